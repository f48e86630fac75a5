// SPDX-License-Identifier: MIT
#pragma once

// XML-RPC as used by URScript: values in XML, transferred over HTTP. A pose is a struct of x, y, z, rx, ry,
// rz. Source: xmlrpc.com specification; URScript rpc_factory.

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "robot/core/result.h"
#include "robot/simulator/urscript/value.h"

namespace tiller::simulator::urscript::xml_rpc {

/// Address of a server.
struct Address {
    std::string host;
    int port = 80;
    std::string path;
};
/// Parses an address such as "http://127.0.0.1:8000/RPC2". Empty if the text is not a valid address.
std::optional<Address> parseAddress(std::string_view url);

/// Returns a complete HTTP request that calls `method`.
/// Errors  ScriptError for a value that XML-RPC cannot represent (infinite, None)
Result<std::string> request(const Address& address, std::string_view method,
                            std::span<const Value> arguments);

/// Returns the reply of the server; empty while it is incomplete.
/// ended  true if the connection has ended
/// Errors  ScriptError: HTTP status, malformed reply, or fault reported by the server
Result<std::optional<Value>> reply(std::string_view received, bool ended);

// A call as received by a server.

struct MethodCall {
    std::string method;
    std::vector<Value> arguments;
};
/// body  body of the HTTP request
/// Errors  ScriptError: malformed, or a type that URScript does not have
Result<MethodCall> readCall(std::string_view body);
/// Returns the body of a reply. None: a reply without a value.
std::string response(const Value& value);
std::string faultResponse(std::string_view text);

}  // namespace tiller::simulator::urscript::xml_rpc
