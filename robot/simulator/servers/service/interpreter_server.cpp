// SPDX-License-Identifier: MIT
#include "robot/simulator/servers/service/interpreter_server.h"

#include <algorithm>
#include <array>
#include <utility>

#include "robot/core/ascii.h"
#include "robot/simulator/controller/controller_model.h"
#include "robot/simulator/programs/program_runner.h"
#include "robot/simulator/urscript/interpreter_mode.h"

namespace tiller::simulator {

namespace {

using urscript::InterpreterMode;

constexpr std::size_t kInterpreterShare = 256 * 1024;  ///< bytes read from one client at a time

std::string discard(std::string_view reason, std::string_view line) {
    // The statement follows the reason, so remove the colon.
    while (!reason.empty() && reason.back() == ':') {
        reason.remove_suffix(1);
    }
    return "discard: " + std::string(reason) + ": " + std::string(line) + "\n";
}

/// Returns the reply to a command that is executed at once; empty if the line is a statement.
std::string stateReply(InterpreterMode* mode, const std::string& line) {
    const InterpreterMode::Counts counts = mode == nullptr ? InterpreterMode::Counts() : mode->counts();
    std::uint32_t number = 0;
    if (line == "skipbuffer" || line == "abort") {
        if (mode != nullptr) {
            line == "abort" ? mode->abortMove() : mode->skip();
        }
        number = counts.lastExecuted;
    } else if (line == "statelastinterpreted") {
        number = counts.lastInterpreted;
    } else if (line == "statelastexecuted") {
        number = counts.lastExecuted;
    } else if (line == "statelastcleared") {
        number = counts.lastCleared;
    } else if (line == "stateunexecuted") {
        number = counts.unexecuted;
    } else {
        return {};
    }
    return "state: " + std::to_string(number) + ": " + line + "\n";
}

}  // namespace

void InterpreterServer::service() {
    const bool mayWrite = plant_.takesScripts();
    for (const native_socket::Descriptor descriptor : takeAccepted()) {
        clients_.push_back(std::make_unique<Client>(descriptor, mayWrite));
        clients_.back()->peer.attach(link());
    }
    int lines = kLinesAtOnce;
    for (const auto& client : clients_) {
        read(*client);
        answer(*client, lines);
        client->peer.flush();
    }
    removeClosed(clients_, [](const Client&) {});
}

void InterpreterServer::read(Client& client) {
    std::array<std::uint8_t, 16 * 1024> buffer;
    std::size_t total = 0;
    while (client.peer.isOpen() && total < kInterpreterShare && client.lines.size() < kMaxWaiting) {
        const std::size_t got = client.peer.receive(buffer);
        if (got == 0) {
            return;
        }
        total += got;
        std::string_view bytes(reinterpret_cast<const char*>(buffer.data()), got);
        while (!bytes.empty()) {
            const std::size_t newline = std::min(bytes.find('\n'), bytes.size());
            if (!client.overlong) {
                client.line += bytes.substr(0, newline);
            }
            if (newline == bytes.size()) {
                break;
            }
            bytes.remove_prefix(newline + 1);
            if (const std::string_view line = trimmed(client.line); !line.empty()) {
                client.lines.emplace_back(line);
            }
            client.line.clear();
            client.overlong = false;
        }
        if (client.line.size() > kMaxLine) {
            client.overlong = true;
            client.line.resize(32);
            client.peer.send(discard("line is too long", client.line));
            client.line.clear();
        }
    }
}

void InterpreterServer::answer(Client& client, int& lines) {
    for (; !client.lines.empty() && lines > 0; --lines) {
        const std::string reply = replyTo(client, client.lines.front());
        if (reply.empty()) {
            return;
        }
        client.lines.pop_front();
        if (!client.peer.send(reply)) {
            client.peer.close();  // the client is not reading its replies
            return;
        }
    }
}

std::string InterpreterServer::replyTo(const Client& client, const std::string& line) {
    if (!client.mayWrite) {
        return discard("the robot is in local control", line);
    }
    InterpreterMode* mode = plant_.programs().interpreterMode();
    if (std::string state = stateReply(mode, line); !state.empty()) {
        return state;
    }
    if (mode == nullptr) {
        return discard("no program is running", line);
    }
    const InterpreterMode::Reply reply = mode->submit(line);
    switch (reply.kind) {
        case InterpreterMode::Reply::Kind::Ack:
            return "ack: " + std::to_string(reply.id) + ": " + line + "\n";
        case InterpreterMode::Reply::Kind::Discard:
            return discard(reply.reason, line);
        case InterpreterMode::Reply::Kind::Wait:
            break;
    }
    return {};
}

}  // namespace tiller::simulator
