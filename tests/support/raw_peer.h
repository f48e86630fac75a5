// SPDX-License-Identifier: MIT
#pragma once

// The server side of a connection for text and byte protocols. A thread runs the script of the test for one
// client after the other.

#include <QByteArray>
#include <QHostAddress>
#include <QTcpServer>
#include <atomic>
#include <functional>
#include <future>
#include <thread>
#include <utility>
#include <vector>

#include "robot/platform/native_socket.h"

namespace tiller::test {

class RawPeer {
public:
    /// The connection of one client. It is closed when the script returns.
    class Link {
    public:
        Link(native_socket::Descriptor socket, const std::atomic<bool>& over) : socket_(socket), over_(over) {
            native_socket::prepare(socket);
        }
        ~Link() {
            if (socket_ >= 0) {
                native_socket::close(socket_);
            }
        }
        Link(const Link&) = delete;
        Link& operator=(const Link&) = delete;

        bool isOver() const { return over_ || closed_; }
        /// True if the client has closed the connection properly, without a reset.
        bool endedInOrder() const { return inOrder_; }
        void send(const QByteArray& bytes) {
            std::span<const std::uint8_t> left(reinterpret_cast<const std::uint8_t*>(bytes.constData()),
                                               static_cast<std::size_t>(bytes.size()));
            while (!left.empty() && !isOver()) {
                const auto sent = native_socket::send(socket_, left);
                if (sent.status == native_socket::Status::Ok) {
                    left = left.subspan(sent.bytes);
                } else if (sent.status != native_socket::Status::WouldBlock) {
                    closed_ = true;
                }
            }
        }
        /// Returns the next line without the line end; null if the client has disconnected or the test is
        /// over.
        QByteArray readLine() {
            while (!received_.contains('\n')) {
                if (isOver()) {
                    return {};
                }
                read();
            }
            const qsizetype end = received_.indexOf('\n');
            const QByteArray line = received_.left(end);
            received_.remove(0, end + 1);
            return line;
        }
        /// Reads everything until the client disconnects or the test is over.
        QByteArray readAll() {
            while (!isOver()) {
                read();
            }
            return received_;
        }
        /// Keeps the connection open without a reader (half open). The caller closes the descriptor.
        native_socket::Descriptor forget() {
            closed_ = true;
            return std::exchange(socket_, -1);
        }
        /// Sends nothing until the client disconnects or the test is over.
        void beMute() { readAll(); }

    private:
        void read() {
            std::array<std::uint8_t, 4096> bytes;
            if (!native_socket::waitReadable(socket_, std::chrono::milliseconds(10))) {
                return;
            }
            const auto got = native_socket::receive(socket_, bytes);
            if (got.status == native_socket::Status::Ok) {
                received_.append(reinterpret_cast<const char*>(bytes.data()),
                                 static_cast<qsizetype>(got.bytes));
            } else if (got.status != native_socket::Status::WouldBlock) {
                closed_ = true;
                inOrder_ = got.status == native_socket::Status::Closed;
            }
        }
        native_socket::Descriptor socket_;
        const std::atomic<bool>& over_;
        bool closed_ = false;
        bool inOrder_ = false;
        QByteArray received_;
    };

    using Script = std::function<void(Link&)>;

    explicit RawPeer(Script script) {
        std::promise<int> listening;
        auto port = listening.get_future();
        thread_ = std::thread([this, script = std::move(script), &listening] {
            Server server;
            server.listen(QHostAddress::LocalHost);
            listening.set_value(server.serverPort());
            while (!over_) {
                server.waitForNewConnection(5);
                while (!server.accepted.empty()) {
                    Link link(server.accepted.front(), over_);
                    server.accepted.erase(server.accepted.begin());
                    ++clients_;
                    script(link);
                }
            }
        });
        port_ = port.get();
    }
    ~RawPeer() {
        over_ = true;
        thread_.join();
    }

    int port() const { return port_; }
    int clients() const { return clients_; }

    /// Returns a port without a listener.
    static int deadPort() {
        QTcpServer server;
        server.listen(QHostAddress::LocalHost);
        return server.serverPort();
    }

private:
    class Server : public QTcpServer {
    public:
        std::vector<native_socket::Descriptor> accepted;

    protected:
        void incomingConnection(qintptr socket) override { accepted.push_back(socket); }
    };

    std::atomic<bool> over_{false};
    std::atomic<int> clients_{0};
    int port_ = 0;
    std::thread thread_;
};

}  // namespace tiller::test
