// SPDX-License-Identifier: MIT
#pragma once

// The server side of a connection in a separate thread. The test controls what it does: reply, send nothing,
// truncate a package, or disconnect.

#include <QHostAddress>
#include <QTcpServer>
#include <atomic>
#include <chrono>
#include <deque>
#include <functional>
#include <future>
#include <thread>

#include "robot/platform/native_socket.h"
#include "robot/rtde/codec.h"
#include "robot/rtde/splitter.h"

namespace tiller::test {

/// Owns the thread that listens on a free loopback port and serves one connection after the other.
class ScriptedPeer {
public:
    /// One connection, which is passed to the script. It is closed when the script returns.
    class Link {
    public:
        Link(native_socket::Descriptor socket, const std::atomic<bool>& stopping)
            : socket_(socket), stopping_(stopping) {
            native_socket::prepare(socket);
        }
        ~Link() { native_socket::close(socket_); }
        Link(const Link&) = delete;
        Link& operator=(const Link&) = delete;

        /// True if the test is over or the client has disconnected. The script should then return.
        bool isOver() const { return stopping_ || closed_; }
        bool isClosed() const { return closed_; }

        void send(std::span<const std::uint8_t> bytes) {
            while (!bytes.empty() && !isOver()) {
                const auto sent = native_socket::send(socket_, bytes);
                if (sent.status == native_socket::Status::Ok) {
                    bytes = bytes.subspan(sent.bytes);
                } else if (sent.status == native_socket::Status::WouldBlock) {
                    read(std::chrono::milliseconds(1));
                } else {
                    closed_ = true;
                }
            }
        }
        /// Waits briefly for the next package of the client. Its payload is valid until the next call.
        std::optional<rtde::PackageView> nextPackage(
            std::chrono::milliseconds atMost = std::chrono::milliseconds(10)) {
            if (auto package = splitter_.next()) {
                return package;
            }
            read(atMost);
            return splitter_.next();
        }
        /// Sends nothing and waits until the client disconnects or the test ends.
        void beMute() {
            while (!isOver()) {
                splitter_.reset();
                read(std::chrono::milliseconds(10));
            }
        }

    private:
        void read(std::chrono::milliseconds atMost) {
            if (!native_socket::waitReadable(socket_, atMost)) {
                return;
            }
            const auto room = splitter_.writable();
            if (room.empty()) {
                return;
            }
            const auto got = native_socket::receive(socket_, room);
            if (got.status == native_socket::Status::Ok) {
                splitter_.commit(got.bytes);
            } else if (got.status != native_socket::Status::WouldBlock) {
                closed_ = true;
            }
        }

        native_socket::Descriptor socket_;
        const std::atomic<bool>& stopping_;
        rtde::PackageSplitter splitter_;
        bool closed_ = false;
    };

    using Script = std::function<void(Link&)>;

    /// script  runs in the peer's thread for every connection
    /// port    0 for a free port
    explicit ScriptedPeer(Script script, std::uint16_t port = 0) {
        std::promise<std::uint16_t> listening;
        auto portKnown = listening.get_future();
        thread_ = std::thread([this, script = std::move(script), port, &listening] {
            Server server;
            if (!server.listen(QHostAddress::LocalHost, port)) {
                listening.set_value(0);
                return;
            }
            listening.set_value(server.serverPort());
            while (!stopping_) {
                server.waitForNewConnection(5);
                while (!server.accepted.empty() && !stopping_) {
                    Link link(server.accepted.front(), stopping_);
                    server.accepted.pop_front();
                    ++connections_;
                    script(link);
                }
            }
            for (const auto socket : server.accepted) {
                native_socket::close(socket);
            }
        });
        port_ = portKnown.get();
    }
    ~ScriptedPeer() {
        stopping_ = true;
        thread_.join();
    }

    std::uint16_t port() const { return port_; }
    int connections() const { return connections_; }

private:
    class Server : public QTcpServer {
    public:
        std::deque<native_socket::Descriptor> accepted;

    protected:
        void incomingConnection(qintptr socket) override { accepted.push_back(socket); }
    };

    std::atomic<bool> stopping_{false};
    std::atomic<int> connections_{0};
    std::uint16_t port_ = 0;
    std::thread thread_;
};

}  // namespace tiller::test
