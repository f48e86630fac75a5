// SPDX-License-Identifier: MIT
// Uses one class of each component that needs more packages than the backend. Records the simulated robot to
// MCAP, reads the file back, compares it with the model, and starts a server for viewers.
#include "robot/control/motions.h"

// Identifiers that Qt's keyword macros would replace. Python.h also uses such names.
struct Names {
    int signals = 1;
    int slots = 2;
    int emit = 3;
    int foreach = 4;
};

#include <unistd.h>
#include <QTemporaryDir>
#include <cstdlib>
#include <iostream>

#include "robot/collision/move_check.h"
#include "robot/divergence/divergence.h"
#include "robot/live/live_output.h"
#include "robot/receive/receiver.h"
#include "robot/recording/formats/open_recording.h"
#include "robot/recording/recorder.h"
#include "robot/simulator/simulator.h"

using namespace tiller;
using namespace std::chrono_literals;

int main() {
    const Names names;
    const QTemporaryDir folder;
    const QString address = QStringLiteral("127.%1.%2.9").arg(10 + getpid() % 200).arg(getpid() / 200 % 250);
    simulator::Simulator robot({.listenAddress = address, .poweredOn = true, .fastTransitions = true});
    robot.start().value();
    receive::Receiver receiver({.host = address});
    receiver.start().value();
    receiver.waitForData(Deadline::after(30s)).value();

    live::LiveOutput live;
    live.start({.port = 0}, receiver).value();

    recording::RecorderOptions options;
    options.path = folder.filePath("run.mcap");
    options.format = recording::formatForPath(options.path).value();
    recording::Recorder recorder;
    recorder.start(options, receiver).value();
    receive::Subscription packets = receiver.subscribe();
    receive::Sample sample(receiver.layout());
    for (int i = 0; i < 100; ++i) {
        packets.next(sample, Deadline::after(30s)).value();
    }
    recorder.stop();
    const auto file = recording::openRecording(options.path).value();
    const auto report = divergence::compare(*file, {.model = RobotModelId::UR5e});
    const bool good = file->rows() >= 50 && report && live.port() != 0 && names.slots == 2;
    std::cout << file->rows() << " rows in " << file->columns().size() << " columns, "
              << (report ? "compared" : report.error().message()) << std::endl;
    return good ? EXIT_SUCCESS : EXIT_FAILURE;
}
