// SPDX-License-Identifier: MIT
// rpc_factory(), which returns an object with callable methods; see remote_calls.h.

#include "robot/simulator/urscript/builtin_table.h"
#include "robot/simulator/urscript/call.h"
#include "robot/simulator/urscript/remote_calls.h"

namespace tiller::simulator::urscript {

namespace {

Status finish(Call& c, std::int32_t handle) {
    StructData data;
    data.handle = handle;
    c.result = Value::structure(std::move(data));
    return Status::Done;
}

Status rpcFactory(Call& c) {
    RemoteCalls& remote = *c.context().remote;
    const bool looks = !c.limits().remoteServersMayBeAbsent;
    if (c.first) {
        if (c.string(0) != "xmlrpc") {
            fault("rpc_factory: type must be \"xmlrpc\"");
        }
        const Result<std::int32_t> handle = looks ? remote.open(c.string(1)) : remote.declare(c.string(1));
        if (!handle.ok()) {
            fault(handle.error());
        }
        if (!looks) {
            return finish(c, *handle);
        }
        c.state = *handle;
        return Status::Again;
    }
    const auto handle = static_cast<std::int32_t>(c.state);
    const Result<bool> opened = remote.opened(handle);
    if (!opened.ok()) {
        fault(opened.error());
    }
    if (!*opened) {
        return Status::Again;
    }
    return finish(c, handle);
}

constexpr BuiltinRow kRpcRows[] = {
    {"rpc_factory(type, url)", rpcFactory},
};

}  // namespace

std::span<const BuiltinRow> rpcBuiltins() {
    return kRpcRows;
}

}  // namespace tiller::simulator::urscript
