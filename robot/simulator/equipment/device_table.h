// SPDX-License-Identifier: MIT
#pragma once

// Table of replies of a device on the network, such as a camera or a gripper. The table is stored in a text
// file.
//
//     protocol xml-rpc                    or: protocol lines
//     address 192.168.1.20:4242           address used by programs
//     # name  | arguments | answer                | delay [s]
//     getPose | 1, *      | p[0.3,0.2,0.1,0,0,0]  | 0.2
//     isReady |           | False
//     isReady |           | True
//
// `*` matches any argument; a single `*` matches any number of arguments. Rows with the same name and
// arguments are used one after the other, and then the last row repeats. The answer `fault TEXT` is an error
// of the device. See README.md.

#include <QString>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "robot/core/result.h"
#include "robot/simulator/urscript/value.h"

namespace tiller::simulator {

struct DeviceAnswer {
    urscript::Value value = urscript::Value::none();  ///< xml-rpc; None: an empty reply
    std::string text;                                 ///< lines: text with line ending; empty: no reply
    std::optional<std::string> fault;                 ///< xml-rpc: a fault; lines: the connection is closed
    double delay = 0;                                 ///< [s]
};

/// Threads  one at a time.
class DeviceTable {
public:
    enum class Protocol { XmlRpc, Lines };

    /// Errors  FileNotReadable; FileCorrupt with file, line and reason
    static Result<DeviceTable> read(const QString& file);
    /// shown  file name for messages
    static Result<DeviceTable> parse(const QString& shown, const QString& text);

    Protocol protocol() const { return protocol_; }
    const QString& host() const { return host_; }
    int port() const { return port_; }

    /// Returns the next answer to a call; empty if no row matches.
    std::optional<DeviceAnswer> answer(std::string_view method, std::span<const urscript::Value> arguments);
    /// Returns the next answer to a request; empty if no row matches.
    std::optional<DeviceAnswer> answer(std::string_view line);

private:
    struct Row {
        std::string name;
        std::string argumentText;
        bool anyArguments = false;
        std::vector<std::optional<urscript::Value>> arguments;  ///< empty element: any value
        DeviceAnswer answer;
        bool isUsed = false;
    };
    Result<void> addRow(const QString& line);
    static Result<void> readArguments(Row& row);
    template <class Matches>
    std::optional<DeviceAnswer> next(Matches matches);

    Protocol protocol_ = Protocol::XmlRpc;
    QString host_;
    int port_ = 0;
    std::vector<Row> rows_;
};

}  // namespace tiller::simulator
