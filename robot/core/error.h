// SPDX-License-Identifier: MIT
#pragma once

// What can go wrong, as a code a program can test, with the context and the controller's own words.
// The texts for people, with what to do next, are in widgets/.

#include <QMetaType>
#include <QString>
#include <string>

#include "robot/core/text.h"

namespace tiller {

enum class ErrorCode {
    None,
    // reaching the controller
    AddressInvalid,     ///< not an address or a host name that resolves
    HostUnreachable,    ///< no route, or nobody answers
    ConnectionRefused,  ///< the host answers, nothing listens on the port
    ConnectionClosed,   ///< the peer ended the connection
    Timeout,            ///< no answer in time
    Cancelled,          ///< the caller ended the wait
    LinkLost,           ///< data stopped coming on a connection that worked
    // understanding it
    ProtocolError,       ///< bytes that are not what the protocol says
    VersionUnsupported,  ///< the controller's software lacks what was asked
    FieldUnknown,        ///< an RTDE field the controller does not have
    RegisterInUse,       ///< another client or a fieldbus owns an RTDE input
    // moving
    NotConnected,
    NotInControl,  ///< our control script does not run
    UnsafeState,   ///< robot mode or safety mode do not allow it
    RemoteControlRequired,
    LimitExceeded,    ///< a value or a target outside what is allowed
    InvalidArgument,  ///< wrong size, not a number, wrong unit by magnitude
    NoSolution,       ///< a pose the arm cannot reach
    Stopped,          ///< a stop came between the command and its end
    Rejected,         ///< the controller said no
    ScriptError,      ///< the controller could not compile or run a script
    // files
    FileNotReadable,
    FileNotWritable,
    FileCorrupt,
    DiskFull,
    Internal,  ///< a defect of ours
};

/// A stable name for logs, `--json` and tests: "ConnectionRefused".
QString errorCodeName(ErrorCode code);

struct Error {
    ErrorCode code = ErrorCode::None;
    QString context;            ///< what was being done, to what: "connect to 192.168.0.10:30004"
    QString controllerMessage;  ///< the controller's or the system's own words, possibly empty

    /// One line for a log: "ConnectionRefused: connect to 192.168.0.10:30004 (Connection refused)".
    QString toString() const;
    /// The same as UTF-8, for programs without Qt.
    std::string message() const { return toString().toStdString(); }
    friend std::ostream& operator<<(std::ostream& out, const Error& error) { return out << error.message(); }
};

}  // namespace tiller

Q_DECLARE_METATYPE(tiller::Error)
