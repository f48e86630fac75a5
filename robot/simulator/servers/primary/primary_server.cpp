// SPDX-License-Identifier: MIT
#include "robot/simulator/servers/primary/primary_server.h"

#include <algorithm>
#include <utility>

#include "robot/simulator/controller/controller_model.h"
#include "robot/simulator/programs/program_runner.h"
#include "robot/simulator/servers/primary/primary_state.h"
#include "robot/simulator/servers/primary/primary_variables.h"

namespace tiller::simulator {

namespace {
constexpr double kStatePeriod = 0.1;  ///< [s]
}

PrimaryServer::PrimaryServer(ControllerModel& plant, bool messages, bool acceptsScripts)
    : plant_(plant)
    , messages_(messages)
    , acceptsScripts_(acceptsScripts)
    , nextState_(plant.elapsed() + kStatePeriod) {}

void PrimaryServer::service() {
    const bool mayWrite = plant_.takesScripts();
    for (const native_socket::Descriptor descriptor : takeAccepted()) {
        clients_.push_back(std::make_unique<Client>(descriptor, mayWrite));
        clients_.back()->peer.attach(link());
        clients_.back()->peer.send(primary::version(plant_.options().software));
    }
    for (const auto& client : clients_) {
        client->intake.read(client->peer, acceptsScripts_ ? &plant_ : nullptr);
        client->peer.flush();
    }
    removeClosed(clients_, [](const Client&) {});
}

void PrimaryServer::publish(const std::vector<primary::Bytes>& messages) {
    const bool due = plant_.elapsed() + 1e-9 >= nextState_;
    if (due) {
        nextState_ += kStatePeriod;
    }
    if (clients_.empty()) {
        return;
    }
    const bool safetyChanged = messages_ && std::ranges::any_of(messages, &primary::isSafetyMode);
    if (due || safetyChanged) {
        sendStates(safetyChanged);
    }
    if (messages_) {
        sendMessages(messages);
        if (due) {
            publishVariables();
        }
    }
}

void PrimaryServer::sendStates(bool evenToTheSlow) {
    const auto first = primary::robotState(plant_.telemetry(), true);
    const auto later = primary::robotState(plant_.telemetry(), false);
    const std::uint64_t identity = plant_.telemetry().identity;
    for (const auto& client : clients_) {
        client->peer.flush();
        client->hasState = (evenToTheSlow || client->peer.pending() == 0) &&
                           client->peer.send(client->knows == identity ? later : first);
        if (client->hasState) {
            client->knows = identity;
        }
    }
}

void PrimaryServer::sendMessages(const std::vector<primary::Bytes>& messages) {
    const auto last = std::ranges::find_if(messages.rbegin(), messages.rend(), &primary::isSafetyMode);
    for (auto message = messages.begin(); message != messages.end(); ++message) {
        const bool safety = primary::isSafetyMode(*message);
        if (safety && message + 1 != last.base()) {
            continue;  // a later mode in this period replaces this mode, which no state contains
        }
        for (const auto& client : clients_) {
            if (!safety || client->hasState) {
                client->peer.send(*message);  // limited by the backlog
            }
        }
    }
}

void PrimaryServer::publishVariables() {
    const urscript::Interpreter* program = plant_.programs().mainProgram();
    if (program == nullptr) {
        return;
    }
    const primary::VariableBodies variables = primary::variablesOf(*program, plant_.options().software);
    const bool changed = variables.values != lastValues_;
    for (const auto& client : clients_) {
        if (client->peer.pending() > 0) {
            continue;
        }
        const auto tell = [&](const std::vector<primary::Bytes>& bodies) {
            for (const primary::Bytes& body : bodies) {
                client->peer.send(primary::variablePackage(plant_.timestampNs(), body));
            }
        };
        const bool isNew =
            std::exchange(client->program, plant_.programs().starts()) != plant_.programs().starts();
        if (isNew) {
            tell(variables.names);
        }
        if (isNew || changed) {
            tell(variables.values);
        }
    }
    lastValues_ = variables.values;
}

}  // namespace tiller::simulator
