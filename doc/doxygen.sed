# Comments are plain text: <name> is no tag and #word no link.
:tags
s|(//.*[^\\])<([A-Za-z][A-Za-z ]*)>|\1\\<\2\\>|
t tags
:links
s|(//.*[^\\])#([A-Za-z])|\1\\#\2|
t links
