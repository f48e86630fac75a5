// SPDX-License-Identifier: MIT
#pragma once

// The RTDE service, port 30004. Source: RTDE guide. Where the guide is not specific, this implementation
// behaves as follows:
//
// - A size field below 3 ends the connection, because the following bytes cannot be parsed.
// - A well-framed package of unknown type is ignored. The reply to a request with an invalid payload is a
//   refusal (version not accepted, recipe ID 0). A data package with an unknown recipe or wrong length is not
//   applied. No text message is sent, because clients would take it for the expected reply.
// - A frequency that is above the maximum or is not a positive number is set to the maximum. A frequency
//   below 1 Hz is set to 1 Hz.
// - A setup after START replaces the recipe from the next package on. An invalid setup stops the stream.
// - START without a valid output recipe is refused; PAUSE is always accepted.
// - PolyScope X notifies new clients while its safety configuration is unconfirmed.

#include <QStringList>
#include <atomic>
#include <deque>
#include <limits>

#include "robot/rtde/codec.h"
#include "robot/rtde/splitter.h"
#include "robot/simulator/net/server.h"
#include "robot/simulator/options/simulator_options.h"
#include "robot/simulator/plant/rtde_values.h"
#include "robot/simulator/servers/rtde/rtde_inputs.h"

namespace tiller::simulator {

class ControllerModel;

class RtdeServer final : public Server {
public:
    explicit RtdeServer(ControllerModel& plant);

    /// Must be called once per control period, before reading.
    void beginPeriod() {
        ++period_;
        inputs_.applyRest();
    }
    void service() override;
    void publish() override;
    void closeClients() override;

    /// Marks inputs as owned by a client that is not simulated, e.g. a fieldbus or a crashed client. Returns
    /// false without any change if an input does not exist or already has an owner.
    bool holdInputs(const QStringList& names);
    void releaseHeldInputs();

    /// Sets the number of clients above which new connections are closed, as by a full connection table.
    void setMaxClients(std::size_t count) { maxClients_ = count; }

    /// Number of input packages of all clients that were applied since the start.
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

        /// Maximum amount of unsent data per client, in addition to the system's socket buffer, before the
        /// client is disconnected [bytes].
        static constexpr std::size_t kBacklog = 64 * 1024;

        Peer peer;
        RtdeInputs::ClientId id;
        rtde::PackageSplitter splitter;
        rtde::ProtocolVersion protocol = rtde::ProtocolVersion::V1;
        std::optional<OutputRecipe> output;
        unsigned divider = 1;  ///< a package is sent in every n-th control period
        bool started = false;
        std::optional<double> leaves;     ///< time at which this surplus client is disconnected [s]
        std::uint64_t startPeriod = 0;    ///< period in which START was confirmed
        std::vector<InputRecipe> inputs;  ///< recipe ID - 1 is the index
        struct Waiting {
            double due;  ///< [s]
            rtde::Bytes package;
        };
        std::deque<Waiting> waiting;  ///< packages that have not been sent yet
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
    /// Send time of a package created in this period [s].
    double departure() const;
    void sendDue(Client& client);
    bool placesAreTaken() const;
    void removeDisconnected();

    ControllerModel& plant_;
    RtdeInputs inputs_;
    std::vector<std::unique_ptr<Client>> clients_;
    std::size_t maxClients_ = std::numeric_limits<std::size_t>::max();
    RtdeInputs::ClientId lastId_ = 0;
    std::uint64_t period_ = 0;  ///< number of the current control period
    rtde::Bytes reply_;
    std::atomic<std::uint64_t> packages_{0};
    std::atomic<std::uint64_t> sent_{0};
    std::atomic<int> connected_{0};
};

}  // namespace tiller::simulator
