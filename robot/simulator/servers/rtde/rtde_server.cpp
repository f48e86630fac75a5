// SPDX-License-Identifier: MIT
#include "robot/simulator/servers/rtde/rtde_server.h"

#include <algorithm>
#include <cmath>

#include "robot/simulator/controller/controller_model.h"
#include "robot/simulator/servers/rtde/rtde_properties.h"

namespace tiller::simulator {

namespace {
constexpr std::size_t kMaxInputRecipes = 255;
/// Maximum number of bytes read from one client per call, so that no client can block the others.
constexpr std::size_t kRtdeShare = 256 * 1024;
/// Maximum number of clients that receive data from a CB3. The connection of an additional client is closed
/// kExtraCb3Client [s] after its START request. Source: Universal Robots forum, threads 2793 and 3673
constexpr int kMaxCb3Clients = 3;
constexpr double kExtraCb3Client = 1.0;
/// Owner of inputs held by an injected fault. Client IDs start at 1.
constexpr RtdeInputs::ClientId kReservedClient = ~RtdeInputs::ClientId{0};
}  // namespace

RtdeServer::RtdeServer(ControllerModel& plant) : plant_(plant), inputs_(plant, plant.options().software) {}

void RtdeServer::service() {
    for (const native_socket::Descriptor descriptor : takeAccepted()) {
        if (clients_.size() >= maxClients_) {
            native_socket::close(descriptor);
            continue;
        }
        clients_.push_back(std::make_unique<Client>(descriptor, ++lastId_));
        clients_.back()->peer.attach(link());
        ++connected_;
        greet(*clients_.back());
    }
    for (const auto& client : clients_) {
        read(*client);
        if (!client->peer.isOpen()) {
            // Release the inputs at once, because the same program may already have reconnected and request
            // them again.
            inputs_.release(client->id);
        }
        client->peer.flush();
    }
    removeDisconnected();
}

void RtdeServer::greet(Client& client) {
    // The only unsolicited text message. Some clients take the first message for the expected reply, so only
    // PolyScope X with an unconfirmed safety configuration sends it.
    if (plant_.options().software.isPolyScopeX() && plant_.power().mode() == RobotMode::ConfirmSafety) {
        reply_.clear();
        rtde::writeControllerText(
            reply_, client.protocol,
            {rtde::TextLevel::Warning, "SafetySetup has not been confirmed yet", "Controller"});
        reply(client);
    }
}

void RtdeServer::removeDisconnected() {
    removeClosed(clients_, [this](const Client& client) {
        inputs_.release(client.id);
        --connected_;
    });
}

void RtdeServer::read(Client& client) {
    std::size_t total = 0;
    while (client.peer.isOpen() && total < kRtdeShare) {
        const std::size_t got = client.peer.receive(client.splitter.writable());
        if (got == 0) {
            return;
        }
        total += got;
        client.splitter.commit(got);
        while (const auto package = client.splitter.next()) {
            handle(client, *package);
        }
        if (client.splitter.fault() != rtde::PackageSplitter::Fault::None) {
            client.peer.close();
        }
    }
}

void RtdeServer::handle(Client& client, const rtde::PackageView& package) {
    reply_.clear();
    switch (package.type) {
        case rtde::PackageType::RequestProtocolVersion:
            onProtocol(client, package.payload);
            break;
        case rtde::PackageType::GetUrControlVersion:
            rtde::writeVersionReply(reply_, plant_.options().software);
            break;
        case rtde::PackageType::SetupOutputs:
            onOutputs(client, package.payload);
            break;
        case rtde::PackageType::SetupInputs:
            onInputs(client, package.payload);
            break;
        case rtde::PackageType::Start:
            if (!client.started && !client.leaves && placesAreTaken()) {
                client.leaves = plant_.elapsed() + kExtraCb3Client;
            }
            client.started = client.output && client.output->isValid();
            client.startPeriod = period_;
            rtde::writeStartReply(reply_, client.started);
            break;
        case rtde::PackageType::Pause:
            client.started = false;
            rtde::writePauseReply(reply_, true);
            break;
        case rtde::PackageType::Data:
            onData(client, package.payload);
            break;
        case rtde::PackageType::TextMessage:
            break;  // no reply, as described in the guide
        case rtde::PackageType::ReadProperties:
            if (hasProperties(plant_.options().software)) {
                writeProperties(reply_, rtde::readPropertiesRequest(package.payload),
                                plant_.options().software);
            }
            break;
    }
    reply(client);
}

bool RtdeServer::placesAreTaken() const {
    return plant_.options().software.isCb3() &&
           std::count_if(clients_.begin(), clients_.end(), [](const auto& client) {
               return client->started && !client->leaves;
           }) >= kMaxCb3Clients;
}

void RtdeServer::reply(Client& client) {
    if (!reply_.empty() && !client.peer.send(reply_)) {
        client.peer.close();
    }
}

void RtdeServer::onProtocol(Client& client, rtde::ByteView payload) {
    const Result<std::uint16_t> wanted = rtde::readProtocolRequest(payload);
    const SoftwareVersion& software = plant_.options().software;
    // CB3 has version 2 from 3.4 on. Source: RTDE guide.
    const std::uint16_t newest = hasProperties(software)                   ? 3
                                 : software >= SoftwareVersion{3, 4, 0, 0} ? 2
                                                                           : 1;
    const bool accepted = wanted && *wanted >= 1 && *wanted <= newest;
    if (accepted) {
        client.protocol = static_cast<rtde::ProtocolVersion>(*wanted);
    }
    rtde::writeProtocolReply(reply_, accepted);
}

unsigned RtdeServer::dividerFor(double frequency) const {
    const double most = plant_.options().software.maxFrequency();
    if (!(frequency > 0) || frequency >= most) {
        return 1;
    }
    // The margin compensates for rounding: a third of the maximum frequency must select every third period.
    return static_cast<unsigned>(std::floor(most / std::max(frequency, 1.0) + 1e-9));
}

void RtdeServer::onOutputs(Client& client, rtde::ByteView payload) {
    const Result<rtde::SetupOutputsRequest> request = rtde::readSetupOutputsRequest(payload, client.protocol);
    if (!request) {
        client.output.reset();
        client.started = false;
        rtde::writeSetupOutputsReply(reply_, client.protocol, 0, {});
        return;
    }
    client.output.emplace(request->names, plant_.options().software,
                          plant_.assumptions().firstVersions == BehaviourOptions::FirstVersions::Latest);
    client.divider = client.protocol == rtde::ProtocolVersion::V1 ? 1 : dividerFor(request->frequency);
    const bool valid = client.output->isValid();
    client.started = client.started && valid;
    rtde::writeSetupOutputsReply(reply_, client.protocol, valid ? 1 : 0, client.output->answers());
}

void RtdeServer::onInputs(Client& client, rtde::ByteView payload) {
    const Result<std::vector<std::string>> names = rtde::readSetupInputsRequest(payload);
    if (!names || client.inputs.size() >= kMaxInputRecipes) {
        rtde::writeSetupInputsReply(reply_, 0, {});
        return;
    }
    RtdeInputs::Claim claim = inputs_.claim(client.id, *names, client.protocol);
    std::uint8_t id = 0;
    if (claim.recipe) {
        client.inputs.push_back(std::move(*claim.recipe));
        id = static_cast<std::uint8_t>(client.inputs.size());
    }
    rtde::writeSetupInputsReply(reply_, id, claim.answers);
}

void RtdeServer::onData(Client& client, rtde::ByteView payload) {
    const auto data = rtde::readInputData(payload);
    if (data && data->recipeId >= 1 && data->recipeId <= client.inputs.size()) {
        inputs_.apply(client.inputs[data->recipeId - 1U], data->values);
        packages_.store(inputs_.packages(), std::memory_order_release);
    }
}

void RtdeServer::publish() {
    for (const auto& client : clients_) {
        if (client->leaves && plant_.elapsed() >= *client->leaves) {
            client->peer.close();
        }
        if (!client->started || !client->peer.isOpen()) {
            continue;
        }
        const std::uint64_t periods = period_ - client->startPeriod;
        const bool on =
            periods > 0 && periods % client->divider == 0 && (link() == nullptr || !link()->drops());
        const auto id =
            client->protocol == rtde::ProtocolVersion::V1 ? std::nullopt : std::optional<std::uint8_t>(1);
        if (plant_.assumptions().data == BehaviourOptions::Data::Even && client->waiting.empty()) {
            if (on) {
                send(*client, client->output->write(plant_.telemetry(), id));
            }
            continue;
        }
        if (on) {
            const rtde::ByteView package = client->output->write(plant_.telemetry(), id);
            const int times = plant_.assumptions().data == BehaviourOptions::Data::Doubled ? 2 : 1;
            for (int i = 0; i < times; ++i) {
                client->waiting.push_back({departure(), {package.begin(), package.end()}});
            }
        }
        sendDue(*client);
    }
    removeDisconnected();
}

void RtdeServer::send(Client& client, rtde::ByteView package) {
    if (client.peer.send(package, plant_.telemetry().timestamp)) {
        sent_.fetch_add(1, std::memory_order_acq_rel);
    } else {
        client.peer.close();  // the client is not reading; the guide requires this
    }
}

std::vector<RtdeDelivery> RtdeServer::deliveries() const {
    std::vector<RtdeDelivery> all;
    for (const auto& client : clients_) {
        if (const auto stamp = client->peer.delivered()) {
            all.push_back({client->peer.port(), *stamp});
        }
    }
    return all;
}

double RtdeServer::departure() const {
    const double now = plant_.elapsed();
    switch (plant_.assumptions().data) {
        case BehaviourOptions::Data::Late: {
            constexpr double kMinValue = 0.004;
            constexpr double kMore = 0.020;
            // Any deterministic scatter is suitable. The queue preserves the order of the packages.
            const auto scatter = static_cast<double>(plant_.tick() * 2654435761U >> 8U & 0xFFU) / 255.0;
            return now + kMinValue + kMore * scatter;
        }
        case BehaviourOptions::Data::Bunched: {
            constexpr std::uint64_t kBunch = 10;
            return now + static_cast<double>(kBunch - 1 - plant_.tick() % kBunch) * plant_.stepTime();
        }
        case BehaviourOptions::Data::Even:
        case BehaviourOptions::Data::Doubled:
            break;
    }
    return now;
}

void RtdeServer::sendDue(Client& client) {
    const double now = plant_.elapsed() + plant_.stepTime() / 2;
    while (!client.waiting.empty() && client.waiting.front().due <= now && client.peer.isOpen()) {
        send(client, client.waiting.front().package);
        client.waiting.pop_front();
    }
}

bool RtdeServer::holdInputs(const QStringList& names) {
    std::vector<std::string> wanted;
    for (const QString& name : names) {
        wanted.push_back(name.toStdString());
    }
    return inputs_.claim(kReservedClient, wanted, rtde::ProtocolVersion::V2).recipe.has_value();
}

void RtdeServer::releaseHeldInputs() {
    inputs_.release(kReservedClient);
}

void RtdeServer::closeClients() {
    for (const auto& client : clients_) {
        inputs_.release(client->id);
    }
    clients_.clear();
    connected_ = 0;
}

}  // namespace tiller::simulator
