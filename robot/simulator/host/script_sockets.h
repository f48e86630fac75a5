// SPDX-License-Identifier: MIT
#pragma once

// TCP client sockets of a running program, by name.
//
// Only a small amount of unread data is buffered, about as much as the program reads in one or two periods.
// TCP then blocks a sender that writes faster than the program reads, so that the newest command is read with
// little delay. More data are buffered only while the program waits for the end of a long message.

#include <QByteArray>
#include <QString>
#include <QTcpSocket>
#include <map>
#include <memory>
#include <string>
#include <string_view>
#include <utility>

#include "robot/simulator/urscript/host.h"

namespace tiller::simulator {

/// Threads  the simulator thread, which processes events between control periods. No function blocks.
class ScriptSockets : public virtual urscript::SocketHost {
public:
    /// Services of this controller that a program reaches at 127.0.0.1. `ports`: standard port to actual
    /// port.
    void setOwnServices(const QString& address, std::map<int, int> ports);

    /// Adds a device on the network of the robot.
    /// host, port  address used by programs
    /// ownPort     actual port of the device, at the address of setOwnServices()
    void setDevice(const QString& host, int port, int ownPort) { devices_[{host.toLower(), port}] = ownPort; }

    bool openSocket(std::string_view name, std::string_view address, int port) override;
    State socketState(std::string_view name) const override;
    void closeSocket(std::string_view name) override;
    bool sendSocket(std::string_view name, std::string_view bytes) override;
    std::string_view receivedBytes(std::string_view name) const override;
    void consumeBytes(std::string_view name, std::size_t count) override;
    void closeAllSockets() { sockets_.clear(); }
    bool hasSockets() const { return !sockets_.empty(); }  ///< If true, events must be processed.

    void serviceSockets();

private:
    struct Connection {
        std::unique_ptr<QTcpSocket> socket;
        QByteArray received;
        mutable bool wantsMore = false;  ///< the program has found the buffered data incomplete

        void takeIn();
    };
    const Connection* find(std::string_view name) const;

    std::map<std::string, Connection, std::less<>> sockets_;
    QString ownAddress_;
    std::map<int, int> ownPorts_;  ///< standard port to actual port
    std::map<std::pair<QString, int>, int> devices_;
};

}  // namespace tiller::simulator
