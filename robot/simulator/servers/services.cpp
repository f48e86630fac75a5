// SPDX-License-Identifier: MIT
#include "robot/simulator/servers/services.h"

#include "robot/simulator/plant.h"

namespace tiller::simulator {

Services::Services(Plant& plant)
    : plant_(plant)
    , dashboard_(plant)
    , primary_(plant, true, true)
    , secondary_(plant, false, true)
    , primaryReadOnly_(plant, true, false)
    , secondaryReadOnly_(plant, false, false)
    , realtime_(plant, true)
    , realtimeReadOnly_(plant, false)
    , rtde_(plant)
    , interpreter_(plant)
    , all_{{&dashboard_, &Ports::dashboard, "dashboard"},
           {&primary_, &Ports::primary, "primary"},
           {&secondary_, &Ports::secondary, "secondary"},
           {&realtime_, &Ports::realtime, "realtime"},
           {&rtde_, &Ports::rtde, "RTDE"},
           {&primaryReadOnly_, &Ports::primaryReadOnly, "read-only primary"},
           {&secondaryReadOnly_, &Ports::secondaryReadOnly, "read-only secondary"},
           {&realtimeReadOnly_, &Ports::realtimeReadOnly, "read-only realtime"},
           {&interpreter_, &Ports::interpreter, "interpreter"}} {}

bool Services::exists(const Entry& entry) const {
    const SoftwareVersion& software = plant_.options().software;
    return entry.server != &interpreter_ || software >= SoftwareVersion{5, 10};
}

Result<void> Services::open(const ControllerOptions& options) {
    const QHostAddress address(options.listenAddress);
    if (address.isNull()) {
        return Error{ErrorCode::AddressInvalid,
                     QStringLiteral("listen on '%1': not an IP address").arg(options.listenAddress),
                     {}};
    }
    const Ports standard;
    for (const Entry& entry : all_) {
        if (!exists(entry)) {
            continue;
        }
        const int wanted = options.anyFreePorts ? 0 : standard.*entry.port + options.portOffset;
        if (wanted < 0 || wanted > 65535) {
            close();
            return Error{
                ErrorCode::InvalidArgument,
                QStringLiteral("port offset %1 leads out of the range of ports").arg(options.portOffset),
                {}};
        }
        if (auto opened = entry.server->open(address, static_cast<std::uint16_t>(wanted), entry.name);
            !opened) {
            close();
            return opened;
        }
    }
    return {};
}

void Services::close() {
    for (const Entry& entry : all_) {
        entry.server->close();
    }
}

Ports Services::ports() const {
    Ports ports;
    for (const Entry& entry : all_) {
        ports.*entry.port = entry.server->port();
    }
    return ports;
}

void Services::service() {
    for (const Entry& entry : all_) {
        entry.server->service();
    }
}

void Services::publish() {
    // Real-time data first: a tenth of a millisecond of messages shall not delay them.
    rtde_.publish();
    realtime_.publish();
    realtimeReadOnly_.publish();
    for (const primary::Bytes& message : plant_.takeOutbox()) {
        primary_.sendMessage(message);
        primaryReadOnly_.sendMessage(message);
    }
    primary_.publish();
    secondary_.publish();
    primaryReadOnly_.publish();
    secondaryReadOnly_.publish();
}

void Services::closeClients() {
    for (const Entry& entry : all_) {
        entry.server->closeClients();
    }
}

void Services::closeScriptClients() {
    primary_.closeClients();
    secondary_.closeClients();
    realtime_.closeClients();
    interpreter_.closeClients();
}

}  // namespace tiller::simulator
