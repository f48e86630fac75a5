// SPDX-License-Identifier: MIT
// Records two seconds to a CSV file, one row per packet.
#include <iostream>
#include <thread>

#include "robot/recording/recorder.h"

using namespace tiller;
using namespace std::chrono_literals;

int main(int, char** argv) {
    receive::Receiver receiver({.host = argv[1]});
    receiver.start().value();
    (void)receiver.waitForData(Deadline::after(5s)).value();

    recording::Recorder recorder;
    recorder.start({.path = "recording.csv", .fields = {"actual_q", "actual_TCP_force"}}, receiver).value();
    std::this_thread::sleep_for(2s);
    recorder.stop();
    if (recorder.progress().state != recording::RecorderState::Finished) {
        std::cerr << recorder.error() << std::endl;
        return EXIT_FAILURE;
    }
    std::cout << recorder.progress().rows << " rows, " << recorder.progress().lost << " lost" << std::endl;
}
