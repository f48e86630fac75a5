// SPDX-License-Identifier: MIT
#include "robot/simulator/equipment/device_server.h"

#include <algorithm>
#include <array>

#include "robot/core/ascii.h"
#include "robot/simulator/plant/plant.h"
#include "robot/simulator/urscript/value_format.h"
#include "robot/simulator/urscript/xml_rpc.h"

namespace tiller::simulator {

namespace {

constexpr std::size_t kLongestRequest = 64 * 1024;
/// Maximum amount of data read from one client per call [bytes].
constexpr std::size_t kDeviceShare = 64 * 1024;

std::string callText(const urscript::xml_rpc::MethodCall& call) {
    std::string text = call.method + '(';
    for (std::size_t i = 0; i < call.arguments.size(); ++i) {
        text += (i > 0 ? ", " : "") + urscript::toStr(call.arguments[i]);
    }
    return text + ')';
}

}  // namespace

void DeviceServer::setPresence(Presence presence) {
    presence_ = presence;
    closeClients();
}

void DeviceServer::service() {
    for (const native_socket::Descriptor descriptor : takeAccepted()) {
        clients_.push_back(std::make_unique<Client>(descriptor));
        clients_.back()->peer.attach(link());
    }
    for (const auto& client : clients_) {
        read(*client);
        sendDue(*client);
        client->peer.flush();
    }
    removeClosed(clients_, [](const Client&) {});
}

void DeviceServer::read(Client& client) {
    std::array<std::uint8_t, 4096> buffer;
    std::size_t total = 0;
    while (client.peer.isOpen() && total < kDeviceShare) {
        const std::size_t got = client.peer.receive(buffer);
        if (got == 0) {
            return;
        }
        total += got;
        const std::string_view bytes(reinterpret_cast<const char*>(buffer.data()), got);
        if (presence_ == Presence::Silent) {
            continue;
        }
        if (table_.protocol() == DeviceTable::Protocol::Lines) {
            takeLines(client, bytes);
        } else {
            client.parser.feed(bytes);
            takeCalls(client);
        }
    }
}

void DeviceServer::takeCalls(Client& client) {
    while (const std::optional<HttpRequest> request = client.parser.next()) {
        HttpResponse response;
        response.contentType = "text/xml";
        double delay = 0;
        if (const auto call = urscript::xml_rpc::readCall(request->body); !call) {
            response.status = 400;
            response.body = urscript::xml_rpc::faultResponse(call.error().controllerMessage.toStdString());
        } else if (const auto answer = table_.answer(call->method, call->arguments); !answer) {
            tellUnknown(callText(*call));
            response.body = urscript::xml_rpc::faultResponse("no answer to " + callText(*call));
        } else {
            delay = answer->delay;
            response.body = answer->fault ? urscript::xml_rpc::faultResponse(*answer->fault)
                                          : urscript::xml_rpc::response(answer->value);
        }
        queue(client, delay, response.toBytes(request->keepAlive, request->method != "HEAD"),
              !request->keepAlive);
    }
    if (client.parser.fault() != 0) {
        client.peer.close();
    }
}

void DeviceServer::takeLines(Client& client, std::string_view bytes) {
    for (const char c : bytes) {
        if (c == '\n' && client.isAnswered && trimmed(client.line).empty()) {
            client.line.clear();  // line ending of a request that was already answered
            client.isAnswered = false;
        } else if (c == '\n') {
            answerLine(client, true);
            client.line.clear();
        } else if (client.line.size() < kLongestRequest) {
            client.line += c;
        } else {
            client.peer.close();
            return;
        }
    }
    // Programs often send a request without a line ending.
    if (!trimmed(client.line).empty() && answerLine(client, false)) {
        client.line.clear();
        client.isAnswered = true;
    }
}

bool DeviceServer::answerLine(Client& client, bool isWhole) {
    const std::optional<DeviceAnswer> answer = table_.answer(client.line);
    if (answer) {
        queue(client, answer->delay, answer->fault ? std::string() : answer->text, answer->fault.has_value());
    } else if (isWhole) {
        tellUnknown(client.line);
    }
    return answer.has_value();
}

void DeviceServer::queue(Client& client, double delay, std::string bytes, bool closes) {
    // Replies are sent in the order of the requests.
    const double earliest = client.answers.empty() ? 0 : client.answers.back().due;
    client.answers.push_back({std::max(earliest, plant_.elapsed() + delay), std::move(bytes), closes});
}

void DeviceServer::sendDue(Client& client) {
    while (!client.answers.empty() && client.answers.front().due <= plant_.elapsed() &&
           client.peer.isOpen()) {
        const Client::Pending& answer = client.answers.front();
        if (!answer.bytes.empty() && !client.peer.send(answer.bytes)) {
            client.peer.close();
            return;
        }
        if (answer.closes) {
            client.peer.closeAfterFlush();
            client.answers.clear();
            return;
        }
        client.answers.pop_front();
    }
}

void DeviceServer::tellUnknown(const std::string& request) {
    plant_.appendToLog("device " + name_.toStdString() + ": its table has no answer to " + request);
}

}  // namespace tiller::simulator
