// SPDX-License-Identifier: MIT
#include "robot/simulator/urscript/remote_calls.h"

namespace tiller::simulator::urscript {

namespace {

Error unreachable(const xml_rpc::Address& address) {
    return scriptError("No XML-RPC server responds at " + address.host + ":" + std::to_string(address.port));
}

}  // namespace

Result<std::int32_t> RemoteCalls::declare(std::string_view url) {
    const auto address = xml_rpc::parseAddress(url);
    if (!address) {
        return scriptError("rpc_factory: \"" + std::string(url) + "\" is not the address of a server");
    }
    if (servers_.size() >= kMaxHandles) {
        return scriptError("rpc_factory: too many handles");
    }
    const auto handle = static_cast<std::int32_t>(servers_.size()) + 1;
    servers_[handle] = *address;
    return handle;
}

Result<std::int32_t> RemoteCalls::open(std::string_view url) {
    const Result<std::int32_t> handle = declare(url);
    if (handle.ok()) {
        const xml_rpc::Address& address = servers_[*handle];
        if (!host_.openSocket(socketOf(-*handle), address.host, address.port)) {
            return unreachable(address);
        }
    }
    return handle;
}

Result<bool> RemoteCalls::opened(std::int32_t handle) {
    switch (host_.socketState(socketOf(-handle))) {
        case SocketHost::State::Connecting:
            return false;
        case SocketHost::State::Open:
            host_.closeSocket(socketOf(-handle));
            return true;
        case SocketHost::State::Closed:
            break;
    }
    return unreachable(servers_[handle]);
}

Result<std::int64_t> RemoteCalls::begin(std::int32_t handle, std::string_view method,
                                        std::span<const Value> arguments) {
    const auto server = servers_.find(handle);
    if (server == servers_.end()) {
        return scriptError("The handle of this server is no longer valid");
    }
    Result<std::string> request = xml_rpc::request(server->second, method, arguments);
    if (!request.ok()) {
        return request.error();
    }
    if (calls_.size() >= kMaxCalls) {
        host_.closeSocket(socketOf(calls_.begin()->first));
        calls_.erase(calls_.begin());
    }
    const std::int64_t call = ++lastCall_;
    if (!host_.openSocket(socketOf(call), server->second.host, server->second.port)) {
        return unreachable(server->second);
    }
    calls_[call] = {std::move(*request), false};
    return call;
}

Result<std::optional<Value>> RemoteCalls::result(std::int64_t number) {
    const auto it = calls_.find(number);
    if (it == calls_.end()) {
        return scriptError("Too many simultaneous calls to XML-RPC servers");
    }
    const std::string socket = socketOf(number);
    const SocketHost::State state = host_.socketState(socket);
    if (state == SocketHost::State::Connecting) {
        return std::optional<Value>();
    }
    if (!it->second.sent) {
        if (!host_.sendSocket(socket, it->second.request)) {
            return scriptError("The XML-RPC server does not respond");
        }
        it->second.sent = true;
    }
    Result<std::optional<Value>> reply =
        xml_rpc::reply(host_.receivedBytes(socket), state == SocketHost::State::Closed);
    if (!reply.ok() || reply->has_value()) {
        host_.closeSocket(socket);
        calls_.erase(it);
    }
    return reply;
}

}  // namespace tiller::simulator::urscript
