// SPDX-License-Identifier: MIT
#pragma once

// A device on the network of the robot. It replies to programs according to its table, with XML-RPC over HTTP
// or with lines of text. It listens on its own port. Programs use the address given in the table.

#include <deque>
#include <string>

#include "robot/simulator/equipment/device_table.h"
#include "robot/simulator/net/http_message.h"
#include "robot/simulator/net/server.h"

namespace tiller::simulator {

class Plant;

class DeviceServer final : public Server {
public:
    enum class Presence {
        Answers,
        Refuses,  ///< the port is closed
        Silent,   ///< connections are accepted; requests get no reply
    };

    DeviceServer(Plant& plant, QString name, DeviceTable table)
        : plant_(plant), name_(std::move(name)), table_(std::move(table)) {}

    const QString& name() const { return name_; }
    const DeviceTable& table() const { return table_; }
    bool isRefusing() const { return presence_ == Presence::Refuses; }
    void setPresence(Presence presence);

    void service() override;
    void closeClients() override { clients_.clear(); }

private:
    struct Client {
        explicit Client(native_socket::Descriptor descriptor) : peer(descriptor, 1 << 20) {}
        Peer peer;
        HttpParser parser;
        std::string line;         ///< protocol lines: start of the next line
        bool isAnswered = false;  ///< protocol lines: a reply was sent before the line ending arrived
        struct Pending {
            double due;  ///< controller time [s]
            std::string bytes;
            bool closes;
        };
        std::deque<Pending> answers;
    };
    void read(Client& client);
    void takeCalls(Client& client);
    void takeLines(Client& client, std::string_view bytes);
    bool answerLine(Client& client, bool isWhole);
    void queue(Client& client, double delay, std::string bytes, bool closes);
    void sendDue(Client& client);
    void tellUnknown(const std::string& request);

    Plant& plant_;
    QString name_;
    DeviceTable table_;
    Presence presence_ = Presence::Answers;
    std::vector<std::unique_ptr<Client>> clients_;
};

}  // namespace tiller::simulator
