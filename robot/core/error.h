// SPDX-License-Identifier: MIT
#pragma once

// Error codes for programs, with the context and the controller's message. User-visible texts with a
// suggested action are in robot/station/text.

#include <QMetaType>
#include <QString>
#include <string>

#include "robot/core/text.h"

namespace tiller {

enum class ErrorCode {
    None,
    // connection
    AddressInvalid,     ///< neither an address nor a host name that resolves
    HostUnreachable,    ///< no route, or no response
    ConnectionRefused,  ///< the host responds, but no process listens on the port
    ConnectionClosed,   ///< the peer ended the connection
    Timeout,            ///< no response in time
    Cancelled,          ///< the caller cancelled the wait
    LinkLost,           ///< no more data on a working connection
    // protocol
    ProtocolError,       ///< received bytes violate the protocol
    VersionUnsupported,  ///< not supported by the software version of the controller
    FieldUnknown,        ///< the controller does not have this RTDE field
    RegisterInUse,       ///< another client or a fieldbus uses the RTDE input
    // motion
    NotConnected,
    NotInControl,  ///< the control program is not running
    UnsafeState,   ///< not permitted in the current robot or safety mode
    RemoteControlRequired,
    LimitExceeded,    ///< a value or target outside the allowed range
    InvalidArgument,  ///< wrong size, NaN, or a value that suggests a wrong unit
    NoSolution,       ///< a pose the arm cannot reach
    Stopped,          ///< stopped before the command was completed
    Rejected,         ///< the controller refused the request
    ScriptError,      ///< the controller could not compile or run a script
    // files
    FileNotReadable,
    FileNotWritable,
    FileCorrupt,
    DiskFull,
    Internal,  ///< defect in this library
};

/// Stable name for logs, `--json` and tests, e.g. "ConnectionRefused".
QString errorCodeName(ErrorCode code);

struct Error {
    ErrorCode code = ErrorCode::None;
    QString context;  ///< the attempted action and its object, e.g. "connect to 192.168.0.10:30004"; for a
                      ///< file: the path
    QString controllerMessage;  ///< original message of the controller or the system; may be empty

    /// One line for logs, e.g. "ConnectionRefused: connect to 192.168.0.10:30004 (Connection refused)".
    QString toString() const;
    /// Like toString(), in UTF-8, for programs without Qt.
    std::string message() const { return toString().toStdString(); }
    friend std::ostream& operator<<(std::ostream& out, const Error& error) { return out << error.message(); }
};

}  // namespace tiller

Q_DECLARE_METATYPE(tiller::Error)
