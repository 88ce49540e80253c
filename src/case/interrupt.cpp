#include "case/interrupt.hpp"

#include <signal.h>

namespace pfem {

namespace {
volatile sig_atomic_t flag = 0;
extern "C" void setFlag(int number) { flag = number; }
}  // namespace

void catchInterrupts() {
    struct sigaction action = {};
    action.sa_handler = setFlag;
    action.sa_flags = static_cast<int>(SA_RESETHAND) | SA_RESTART;
    sigemptyset(&action.sa_mask);
    sigaction(SIGINT, &action, nullptr);
    sigaction(SIGTERM, &action, nullptr);
    struct sigaction hangUp = {};
    sigaction(SIGHUP, nullptr, &hangUp);
    if (hangUp.sa_handler != SIG_IGN) sigaction(SIGHUP, &action, nullptr);
    signal(SIGPIPE, SIG_IGN);
}

int interrupted() { return flag; }

const char* signalName(int number) {
    switch (number) {
        case SIGINT:
            return "SIGINT";
        case SIGTERM:
            return "SIGTERM";
        case SIGHUP:
            return "SIGHUP";
        default:
            return "a signal";
    }
}

void clearInterrupt() { flag = 0; }

}  // namespace pfem
