#include "case/interrupt.hpp"

#include <signal.h>

namespace pfem {

namespace {
volatile sig_atomic_t flag = 0;
extern "C" void setFlag(int) {
    flag = 1;
}
}  // namespace

void catchInterrupts() {
    struct sigaction action = {};
    action.sa_handler = setFlag;
    action.sa_flags = static_cast<int>(SA_RESETHAND) | SA_RESTART;
    sigemptyset(&action.sa_mask);
    sigaction(SIGINT, &action, nullptr);
    sigaction(SIGTERM, &action, nullptr);
}

bool interrupted() {
    return flag != 0;
}

void clearInterrupt() {
    flag = 0;
}

}  // namespace pfem
