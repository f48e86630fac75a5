// SPDX-License-Identifier: MIT
// Sets an output, then reads it and an input. Works with and without a running program.
#include <iostream>

#include "robot/io/outputs.h"
#include "robot/receive/robot_state.h"

using namespace tiller;
using namespace std::chrono_literals;

int main(int, char** argv) {
    receive::Receiver receiver({.host = argv[1]});
    receiver.start().value();
    (void)receiver.waitForData(Deadline::after(5s)).value();

    io::Outputs outputs({.host = argv[1]}, io::OutputFeedback::fromReceiver(receiver));
    outputs.setDigitalOutput(0, true, Deadline::after(3s)).value();  // returns once confirmed by the robot
    outputs.setAnalogOutput(0, io::AnalogDomain::Voltage, 0.5, Deadline::after(3s)).value();  // 5 V
    const receive::Sample sample = receiver.latest();
    const receive::RobotState state(sample);
    std::cout << "outputs " << state.digitalOutputs().value_or(0) << ", inputs "
              << state.digitalInputs().value_or(0) << std::endl;
}
