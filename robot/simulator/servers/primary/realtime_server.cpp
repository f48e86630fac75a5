// SPDX-License-Identifier: MIT
#include "robot/simulator/servers/primary/realtime_server.h"

#include "robot/simulator/controller/controller_model.h"
#include "robot/simulator/servers/primary/realtime_record.h"

namespace tiller::simulator {

RealtimeServer::RealtimeServer(ControllerModel& plant, bool acceptsScripts)
    : plant_(plant), acceptsScripts_(acceptsScripts) {}

void RealtimeServer::service() {
    const bool mayWrite = plant_.takesScripts();
    for (const native_socket::Descriptor descriptor : takeAccepted()) {
        clients_.push_back(std::make_unique<Client>(descriptor, mayWrite));
        clients_.back()->peer.attach(link());
    }
    for (const auto& client : clients_) {
        client->intake.read(client->peer, acceptsScripts_ ? &plant_ : nullptr);
        client->peer.flush();
    }
    removeClosed(clients_, [](const Client&) {});
}

void RealtimeServer::publish() {
    if (clients_.empty()) {
        return;
    }
    writeRealtimeRecord(plant_.telemetry(), record_);
    for (const auto& client : clients_) {
        client->peer.flush();
        if (client->peer.pending() == 0) {
            client->peer.send(record_);
        }
    }
}

}  // namespace tiller::simulator
