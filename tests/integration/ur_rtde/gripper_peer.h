// SPDX-License-Identifier: MIT
#pragma once

// The socket of the Robotiq URCap according to its documentation, in a separate thread. A motion ends after
// three queries of its status.

#include <QHostAddress>
#include <QTcpServer>
#include <QTcpSocket>
#include <atomic>
#include <future>
#include <map>
#include <thread>

namespace tiller::test {

class GripperPeer {
public:
    static constexpr int kOpen = 3;
    static constexpr int kClosed = 230;

    GripperPeer() {
        std::promise<int> listening;
        auto port = listening.get_future();
        thread_ = std::thread([this, promise = std::move(listening)]() mutable { run(promise); });
        port_ = port.get();
    }
    ~GripperPeer() {
        quit_ = true;
        thread_.join();
    }
    int port() const { return port_; }

private:
    void run(std::promise<int>& listening) {
        QTcpServer server;
        server.listen(QHostAddress::LocalHost);
        listening.set_value(server.serverPort());
        while (!quit_) {
            if (!server.waitForNewConnection(20)) {
                continue;
            }
            const std::unique_ptr<QTcpSocket> client(server.nextPendingConnection());
            while (!quit_ && client->state() == QAbstractSocket::ConnectedState) {
                if (!client->canReadLine() && !client->waitForReadyRead(20)) {
                    continue;
                }
                while (client->canReadLine()) {
                    client->write(answer(client->readLine().trimmed()));
                    client->flush();
                }
            }
        }
    }

    QByteArray answer(const QByteArray& line) {
        const QByteArrayList words = line.split(' ');
        if (words.size() == 2 && words[0] == "GET") {
            return words[1] + ' ' + QByteArray::number(value(words[1])) + '\n';
        }
        for (qsizetype i = 1; i + 1 < words.size(); i += 2) {
            set(words[i], words[i + 1].toInt());
        }
        return "ack";
    }

    void set(const QByteArray& name, int number) {
        if (name == "POS") {
            values_["PRE"] = number;
            target_ = std::clamp(number, kOpen, kClosed);
            looks_ = 0;
            return;
        }
        values_[name] = number;
        if (name == "ACT") {
            values_["STA"] = number == 1 ? 3 : 0;
        } else if (name == "ATR" && number == 1) {
            values_["FLT"] = 0x0F;
        }
    }

    int value(const QByteArray& name) {
        constexpr int kLooks = 3;
        if (name == "OBJ") {
            ++looks_;
            if (looks_ >= kLooks) {
                values_["POS"] = target_;
            }
            return looks_ >= kLooks ? 3 : 0;
        }
        return values_[name];
    }

    std::map<QByteArray, int> values_;
    int target_ = kOpen;
    int looks_ = 0;
    int port_ = 0;
    std::atomic<bool> quit_{false};
    std::thread thread_;
};

}  // namespace tiller::test
