// SPDX-License-Identifier: MIT
#include "robot/core/error.h"

namespace tiller {

QString errorCodeName(ErrorCode code) {
    switch (code) {
        case ErrorCode::None:
            return QStringLiteral("None");
        case ErrorCode::AddressInvalid:
            return QStringLiteral("AddressInvalid");
        case ErrorCode::HostUnreachable:
            return QStringLiteral("HostUnreachable");
        case ErrorCode::ConnectionRefused:
            return QStringLiteral("ConnectionRefused");
        case ErrorCode::ConnectionClosed:
            return QStringLiteral("ConnectionClosed");
        case ErrorCode::Timeout:
            return QStringLiteral("Timeout");
        case ErrorCode::Cancelled:
            return QStringLiteral("Cancelled");
        case ErrorCode::LinkLost:
            return QStringLiteral("LinkLost");
        case ErrorCode::ProtocolError:
            return QStringLiteral("ProtocolError");
        case ErrorCode::VersionUnsupported:
            return QStringLiteral("VersionUnsupported");
        case ErrorCode::FieldUnknown:
            return QStringLiteral("FieldUnknown");
        case ErrorCode::RegisterInUse:
            return QStringLiteral("RegisterInUse");
        case ErrorCode::NotConnected:
            return QStringLiteral("NotConnected");
        case ErrorCode::NotInControl:
            return QStringLiteral("NotInControl");
        case ErrorCode::UnsafeState:
            return QStringLiteral("UnsafeState");
        case ErrorCode::RemoteControlRequired:
            return QStringLiteral("RemoteControlRequired");
        case ErrorCode::LimitExceeded:
            return QStringLiteral("LimitExceeded");
        case ErrorCode::InvalidArgument:
            return QStringLiteral("InvalidArgument");
        case ErrorCode::NoSolution:
            return QStringLiteral("NoSolution");
        case ErrorCode::Stopped:
            return QStringLiteral("Stopped");
        case ErrorCode::Rejected:
            return QStringLiteral("Rejected");
        case ErrorCode::ScriptError:
            return QStringLiteral("ScriptError");
        case ErrorCode::FileNotReadable:
            return QStringLiteral("FileNotReadable");
        case ErrorCode::FileNotWritable:
            return QStringLiteral("FileNotWritable");
        case ErrorCode::FileCorrupt:
            return QStringLiteral("FileCorrupt");
        case ErrorCode::DiskFull:
            return QStringLiteral("DiskFull");
        case ErrorCode::Internal:
            return QStringLiteral("Internal");
    }
    return QStringLiteral("Internal");
}

QString Error::toString() const {
    QString text = errorCodeName(code);
    if (!context.isEmpty()) {
        text += QStringLiteral(": ") + context;
    }
    if (!controllerMessage.isEmpty()) {
        text += QStringLiteral(" (") + controllerMessage + QLatin1Char(')');
    }
    return text;
}

}  // namespace tiller
