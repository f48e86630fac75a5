// SPDX-License-Identifier: MIT
#pragma once

// Common base of all services of the controller. A service has one port and any number of clients. It reads
// in each cycle of the loop and writes after each control period.

#include <QHostAddress>
#include <cstdint>
#include <memory>
#include <vector>

#include "robot/core/result.h"
#include "robot/simulator/net/link.h"
#include "robot/simulator/net/listener.h"
#include "robot/simulator/net/peer.h"

namespace tiller::simulator {

/// Threads  the simulator thread, also for open()
class Server {
public:
    virtual ~Server() = default;

    /// Sets the link between this service and its clients.
    void setLink(Link* link) { link_ = link; }
    /// poller  watches the port; must outlive this object
    Result<void> open(const QHostAddress& address, std::uint16_t port, const char* name,
                      SocketPoller& poller) {
        auto opened = listener_.open(address, port, name);
        if (opened) {
            poller.addPort(listener_.socketDescriptor());
        }
        return opened;
    }
    void close() {
        listener_.close();
        closeClients();
    }
    std::uint16_t port() const { return listener_.serverPort(); }

    /// Accepts new clients, reads all data and sends replies.
    virtual void service() = 0;
    /// Sends the data of a control period.
    virtual void publish() {}
    virtual void closeClients() = 0;

protected:
    std::vector<native_socket::Descriptor> takeAccepted() { return listener_.takeAccepted(); }
    /// The link of this service, for peer.attach() with a new client.
    Link* link() const { return link_; }

private:
    Link* link_ = nullptr;
    Listener listener_;
};

/// Removes clients whose connection has ended.
/// leaving  called for each of these clients before it is removed
template <class Client, class Leaving>
void removeClosed(std::vector<std::unique_ptr<Client>>& clients, Leaving leaving) {
    std::erase_if(clients, [&leaving](const std::unique_ptr<Client>& client) {
        if (client->peer.isOpen()) {
            return false;
        }
        leaving(*client);
        return true;
    });
}

}  // namespace tiller::simulator
