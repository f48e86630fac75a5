// SPDX-License-Identifier: MIT
#pragma once

// The RTDE service, port 30004. Source: RTDE guide. What the guide leaves open is decided here so:
//
// - A size field below 3 ends the connection: nothing after it could be understood.
// - A well-framed package of unknown type is ignored. A request whose payload makes no sense is refused in
//   the reply that belongs to it (version not accepted, recipe id 0); a data package of unknown recipe or
//   wrong length is not applied. No text message is sent: clients take it for the answer they wait for.
// - A frequency that is not a number above zero, or is above the maximum, means the maximum; below 1 Hz
//   means 1 Hz.
// - A setup while started replaces the recipe from the next package on; an invalid one stops the stream.
// - START without a valid output recipe is refused, PAUSE always accepted.
// - PolyScope X informs new clients while its safety configuration has not been confirmed.

#include <QStringList>
#include <atomic>
#include <deque>

#include "robot/rtde/codec.h"
#include "robot/rtde/splitter.h"
#include "robot/simulator/servers/net/server.h"
#include "robot/simulator/servers/rtde/rtde_inputs.h"
#include "robot/simulator/servers/rtde/rtde_values.h"
#include "robot/simulator/simulator.h"

namespace tiller::simulator {

class Plant;

class RtdeServer final : public Server {
public:
    explicit RtdeServer(Plant& plant);

    /// Once a control period, before anything is read.
    void beginPeriod() {
        ++period_;
        inputs_.applyRest();
    }
    void service() override;
    void publish() override;
    void closeClients() override;

    /// Inputs owned by somebody who is not here: a fieldbus, a client that died. False, and nothing taken,
    /// when one of them does not exist or has an owner.
    bool holdInputs(const QStringList& names);
    void releaseHeldInputs();

    /// Of all clients since the start.
    /// Threads  any
    std::uint64_t inputPackages() const { return packages_.load(std::memory_order_acquire); }
    std::uint64_t outputPackages() const { return sent_.load(std::memory_order_acquire); }
    /// The newest data package that each client can read.
    std::vector<RtdeDelivery> deliveries() const;
    /// Threads  any
    int clients() const { return connected_.load(std::memory_order_acquire); }

private:
    struct Client {
        Client(native_socket::Descriptor descriptor, RtdeInputs::ClientId number)
            : peer(descriptor, kBacklog), id(number) {}

        /// What a client may lag behind, besides the system's own buffer, before it is dropped [bytes].
        static constexpr std::size_t kBacklog = 64 * 1024;

        Peer peer;
        RtdeInputs::ClientId id;
        rtde::PackageSplitter splitter;
        rtde::ProtocolVersion protocol = rtde::ProtocolVersion::V1;
        std::optional<OutputRecipe> output;
        unsigned divider = 1;  ///< every n-th control period
        bool started = false;
        std::optional<double> leaves;     ///< when it is closed, as one too many [s]
        std::uint64_t startPeriod = 0;    ///< the period that answered START
        std::vector<InputRecipe> inputs;  ///< index + 1 is the recipe id
        struct Waiting {
            double due;  ///< [s]
            rtde::Bytes package;
        };
        std::deque<Waiting> waiting;  ///< packages that have not left yet
    };

    void greet(Client& client);
    void read(Client& client);
    void handle(Client& client, const rtde::PackageView& package);
    void onProtocol(Client& client, rtde::ByteView payload);
    void onOutputs(Client& client, rtde::ByteView payload);
    void onInputs(Client& client, rtde::ByteView payload);
    void onData(Client& client, rtde::ByteView payload);
    unsigned dividerFor(double frequency) const;
    void reply(Client& client);
    void send(Client& client, rtde::ByteView package);
    /// When a package of now leaves [s].
    double departure() const;
    void sendDue(Client& client);
    bool placesAreTaken() const;
    void removeGone();

    Plant& plant_;
    RtdeInputs inputs_;
    std::vector<std::unique_ptr<Client>> clients_;
    RtdeInputs::ClientId lastId_ = 0;
    std::uint64_t period_ = 0;  ///< that is under way, or the last one
    rtde::Bytes reply_;
    std::atomic<std::uint64_t> packages_{0};
    std::atomic<std::uint64_t> sent_{0};
    std::atomic<int> connected_{0};
};

}  // namespace tiller::simulator
