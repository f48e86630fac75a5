// SPDX-License-Identifier: MIT
// Reads arbitrary bytes as a reply of an XML-RPC server and as a call of a client. The result must be a value
// or an error with its reason. A value that was read can be written, and has the same type when it is read
// again.

#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string>
#include <string_view>

#include "robot/simulator/urscript/xml_rpc.h"

using namespace tiller::simulator::urscript;

namespace {

void expectTheSameAgain(const Value& value) {
    const std::string body = xml_rpc::response(value);
    const auto again = xml_rpc::reply(
        "HTTP/1.1 200 OK\r\nContent-Length: " + std::to_string(body.size()) + "\r\n\r\n" + body, true);
    // Numbers that are not finite and strings that XML does not permit cannot be represented in a reply.
    if (again.ok() && (!again->has_value() || (*again)->type() != value.type())) {
        std::abort();
    }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const std::string_view bytes(reinterpret_cast<const char*>(data), size);
    const std::string whole = "HTTP/1.0 200 OK\r\n\r\n" + std::string(bytes);
    for (const std::string_view received : {bytes, std::string_view(whole)}) {
        const auto reply = xml_rpc::reply(received, true);
        if (!reply.ok() && reply.error().controllerMessage.isEmpty()) {
            std::abort();
        }
        if (reply.ok() && reply->has_value()) {
            expectTheSameAgain(**reply);
        }
    }
    const auto call = xml_rpc::readCall(bytes);
    if (!call.ok() && call.error().controllerMessage.isEmpty()) {
        std::abort();
    }
    if (call.ok()) {
        for (const Value& argument : call->arguments) {
            expectTheSameAgain(argument);
        }
    }
    return 0;
}
