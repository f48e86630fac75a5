// SPDX-License-Identifier: MIT
// A program that takes control and jogs until somebody kills it: jog_helper <host> <primary port> <rtde port>
#include <QCoreApplication>
#include <cstdio>
#include <thread>

#include "robot/control/controller.h"

using namespace tiller;
using namespace tiller::control;

int main(int argc, char** argv) {
    const QCoreApplication app(argc, argv);
    ControllerOptions options;
    options.host = app.arguments().at(1);
    options.primaryPort = app.arguments().at(2).toInt();
    options.rtdePort = app.arguments().at(3).toInt();
    options.priority = 0;
    Controller controller(options);
    const auto taken = controller.takeControl(Deadline::after(std::chrono::seconds(30)));
    if (!taken) {
        std::fprintf(stderr, "%s\n", qPrintable(taken.error().toString()));
        return 1;
    }
    JogTarget target;
    target.twist.linear.z() = 0.1;
    JogId jog = kNoMotion;
    while (true) {
        // On a busy machine this thread may come late; then it presses again.
        if (!controller.refreshJog(jog)) {
            const auto started = controller.startJog(target);
            jog = started ? *started : kNoMotion;
        }
        std::this_thread::sleep_for(std::chrono::milliseconds(10));
    }
}
