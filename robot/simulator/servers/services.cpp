// SPDX-License-Identifier: MIT
#include "robot/simulator/servers/services.h"

#include <algorithm>
#include <map>

#include "robot/simulator/controller/controller_model.h"
#include "robot/simulator/host/script_host.h"
#include "robot/simulator/urscript/program.h"

namespace tiller::simulator {

namespace {

/// Returns the current settings for reading pendant programs.
pendant::PendantSource pendantSource(const ControllerModel& plant) {
    const BehaviourOptions& assumptions = plant.assumptions();
    pendant::PendantSource source;
    source.software = plant.options().software;
    source.isReserved = [](const QString& name) { return urscript::isReservedName(name.toStdString()); };
    source.hasFunction = [&plant](const QString& name) {
        return urscript::isAvailable(name.toStdString(), plant.programs().compileOptions());
    };
    source.eventNeedsEdge = assumptions.eventNode == BehaviourOptions::EventNode::Edge;
    source.unknownUrcap =
        assumptions.unknownUrcap == BehaviourOptions::UnknownUrcap::Skip  ? pendant::UnknownUrcap::Skip
        : assumptions.unknownUrcap == BehaviourOptions::UnknownUrcap::Ask ? pendant::UnknownUrcap::Ask
                                                                          : pendant::UnknownUrcap::Refuse;
    if (!plant.options().urcapsFolder.isEmpty()) {
        (void)source.urcaps.addFolder(plant.options().urcapsFolder);  // checked by Simulator::start()
    }
    return source;
}

}  // namespace

Services::Services(ControllerModel& plant, FaultServer::Handler faults)
    : plant_(plant)
    , link_(plant.options().seed)
    , store_(plant.options().programsFolder, [&plant] { return pendantSource(plant); })
    , dashboard_(plant, store_)
    , robotApi_(plant, store_)
    , primary_(plant, true, true)
    , secondary_(plant, false, true)
    , primaryReadOnly_(plant, true, false)
    , secondaryReadOnly_(plant, false, false)
    , realtime_(plant, true)
    , realtimeReadOnly_(plant, false)
    , rtde_(plant)
    , interpreter_(plant)
    , faults_(std::move(faults)) {
    const SoftwareVersion& software = plant.options().software;
    if (!software.isPolyScopeX()) {
        all_.push_back({&dashboard_, &Ports::dashboard, "dashboard"});
    } else if (software >= SoftwareVersion{10, 11, 0, 0}) {
        all_.push_back({&robotApi_, &Ports::robotApi, "Robot API"});
    }
    all_.insert(all_.end(), {{&primary_, &Ports::primary, "primary"},
                             {&secondary_, &Ports::secondary, "secondary"},
                             {&realtime_, &Ports::realtime, "realtime"},
                             {&primaryReadOnly_, &Ports::primaryReadOnly, "read-only primary"},
                             {&secondaryReadOnly_, &Ports::secondaryReadOnly, "read-only secondary"},
                             {&realtimeReadOnly_, &Ports::realtimeReadOnly, "read-only realtime"},
                             {&gripper_, &Ports::gripper, "gripper"}});
    if (software >= SoftwareVersion{3, 2, 0, 0}) {
        all_.push_back({&rtde_, &Ports::rtde, "RTDE"});
    }
    if (software >= SoftwareVersion{5, 10, 0, 0}) {
        all_.push_back({&interpreter_, &Ports::interpreter, "interpreter"});
    }
    all_.push_back({&faults_, &Ports::faults, "fault"});
    for (const Entry& entry : all_) {
        if (entry.server != &faults_) {
            entry.server->setLink(&link_);
        }
    }
}

Result<void> Services::openOne(const Entry& entry, const QHostAddress& address,
                               const SimulatorOptions& options) {
    const Ports standard;
    const auto at = [&](int port) -> Result<void> {
        if (port < 0 || port > 65535) {
            return Error{
                ErrorCode::InvalidArgument,
                QStringLiteral("the port numbers with port offset %1 exceed 65535").arg(options.portOffset),
                {}};
        }
        return entry.server->open(address, static_cast<std::uint16_t>(port), entry.name, link_.poller());
    };
    const int wanted = options.anyFreePorts ? 0 : standard.*entry.port + options.portOffset;
    if (entry.server == &gripper_ && wanted > 65535) {
        return {};  // with an offset, this port may exceed the valid range
    }
    const Result<void> opened = at(wanted);
    // Most systems reserve port 80 or run a web server on it.
    constexpr int kOtherWebPort = 8080;
    return opened || entry.server != &robotApi_ || options.anyFreePorts
               ? opened
               : at(kOtherWebPort + options.portOffset);
}

Result<void> Services::open(const SimulatorOptions& options) {
    const QHostAddress address(options.listenAddress);
    if (address.isNull()) {
        return Error{ErrorCode::AddressInvalid,
                     QStringLiteral("listen on '%1': not an IP address").arg(options.listenAddress),
                     {}};
    }
    for (const Entry& entry : all_) {
        if (auto opened = openOne(entry, address, options); !opened) {
            close();
            return opened;
        }
    }
    for (const SimulatorOptions::Device& device : options.devices) {
        Result<DeviceTable> table = DeviceTable::read(device.file);
        if (!table) {
            close();
            return table.error();
        }
        devices_.push_back(std::make_unique<DeviceServer>(plant_, device.name, std::move(*table)));
        devices_.back()->setLink(&link_);
    }
    // If the services listen on all addresses, programs can use 127.0.0.1.
    const bool everywhere = address == QHostAddress(QHostAddress::AnyIPv4);
    std::map<int, int> own;
    for (const Entry& entry : all_) {
        if (entry.server->port() != 0) {
            own.emplace(Ports().*entry.port, entry.server->port());
        }
    }
    plant_.scriptHost().setOwnServices(everywhere ? Text("127.0.0.1") : options.listenAddress,
                                       std::move(own));
    for (const auto& device : devices_) {
        if (Result<void> opened = openDevice(*device); !opened) {
            close();
            return opened;
        }
    }
    return {};
}

Result<void> Services::openDevice(DeviceServer& device) {
    // Use any free port. Programs reach the device at the address in its table.
    Result<void> opened =
        device.open(QHostAddress(plant_.options().listenAddress), 0, "device", link_.poller());
    if (opened) {
        plant_.scriptHost().setDevice(device.table().host(), device.table().port(), device.port());
    }
    return opened;
}

DeviceServer* Services::device(const QString& name) const {
    const auto found = std::find_if(devices_.begin(), devices_.end(),
                                    [&name](const auto& device) { return device->name() == name; });
    return found == devices_.end() ? nullptr : found->get();
}

Result<void> Services::setPresence(DeviceServer& device, DeviceServer::Presence presence) {
    const bool wasRefusing = device.isRefusing();
    device.setPresence(presence);
    if (device.isRefusing() && !wasRefusing) {
        device.close();
    } else if (wasRefusing && !device.isRefusing()) {
        return openDevice(device);
    }
    return {};
}

void Services::close() {
    for (const Entry& entry : all_) {
        entry.server->close();
    }
    devices_.clear();
}

Ports Services::ports() const {
    Ports ports = Ports::none();
    for (const Entry& entry : all_) {
        ports.*entry.port = entry.server->port();
    }
    return ports;
}

void Services::service() {
    link_.setTime(plant_.elapsed());
    for (const Entry& entry : all_) {
        if (entry.server != &faults_) {
            entry.server->service();
        }
    }
    for (const auto& device : devices_) {
        device->service();
    }
}

void Services::publish() {
    link_.setTime(plant_.elapsed());
    gripper_.step(plant_.stepTime(), plant_.telemetry().powered);
    // Send real-time data first, because processing the messages takes 0.1 ms.
    rtde_.publish();
    realtime_.publish();
    realtimeReadOnly_.publish();
    const std::vector<primary::Bytes> messages = plant_.takeOutbox();
    for (PrimaryServer* const server : {&primary_, &secondary_, &primaryReadOnly_, &secondaryReadOnly_}) {
        server->publish(messages);
    }
}

void Services::closeClients() {
    for (const Entry& entry : all_) {
        if (entry.server != &faults_) {
            entry.server->closeClients();
        }
    }
    for (const auto& device : devices_) {
        device->closeClients();
    }
}

void Services::closeScriptClients() {
    primary_.closeClients();
    secondary_.closeClients();
    realtime_.closeClients();
    interpreter_.closeClients();
}

}  // namespace tiller::simulator
