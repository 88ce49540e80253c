// Nothing: CMake wants a file of the target whose precompiled headers the tests share.
