// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/local_simulator.h"

#include <QCoreApplication>

namespace tiller::app {
namespace {

constexpr int kAddressesToTry = 32;

}  // namespace

Result<RobotAddress> LocalSimulator::start() {
    if (controller_ && controller_->isRunning()) {
        return address_;
    }
    Error lastError;
    for (int last = 1; last <= kAddressesToTry; ++last) {
        simulator::SimulatorOptions options;
        options.listenAddress = QStringLiteral("127.0.0.%1").arg(last);
        auto controller = std::make_unique<simulator::Simulator>(options);
        const Result<void> started = controller->start();
        if (started) {
            controller_ = std::move(controller);
            address_ = {QCoreApplication::translate("LocalSimulator", "Simulated UR5e"),
                        options.listenAddress, 0, true};
            return address_;
        }
        lastError = started.error();
    }
    return lastError;
}

QList<simulator::Simulator*> LocalSimulator::controllers() const {
    QList<simulator::Simulator*> running;
    for (simulator::Simulator* controller : {controller_.get(), borrowed_}) {
        if (controller != nullptr && controller->isRunning()) {
            running.append(controller);
        }
    }
    return running;
}

simulator::Simulator* LocalSimulator::controllerOf(const SessionState& state) const {
    if (!state.simulated || !state.hasData()) {
        return nullptr;
    }
    for (simulator::Simulator* controller : controllers()) {
        if (controller->listenAddress() == state.address &&
            controller->options().portOffset == state.portOffset) {
            return controller;
        }
    }
    return nullptr;
}

void LocalSimulator::stop() {
    controller_.reset();
}

}  // namespace tiller::app
