// SPDX-License-Identifier: MIT
#include "robot/simulator/net/listener.h"

#include <utility>

namespace tiller::simulator {

Result<void> Listener::open(const QHostAddress& address, std::uint16_t port, const char* service) {
    setListenBacklogSize(64);
    if (listen(address, port)) {
        return {};
    }
    const QString where = QStringLiteral("%1 port %2 of address %3")
                              .arg(QString::fromLatin1(service))
                              .arg(port)
                              .arg(address.toString());
    switch (serverError()) {
        case QAbstractSocket::AddressInUseError:
            return Error{
                ErrorCode::Rejected,
                where + QStringLiteral(" is in use: end the program that uses this port, or start this "
                                       "controller with another address (127.0.0.2) or port offset"),
                errorString()};
        case QAbstractSocket::SocketAddressNotAvailableError:
            return Error{ErrorCode::AddressInvalid,
                         where + QStringLiteral(" cannot be opened: this machine has no such address"),
                         errorString()};
        default:
            return Error{ErrorCode::Rejected, where + QStringLiteral(" cannot be opened"), errorString()};
    }
}

std::vector<native_socket::Descriptor> Listener::takeAccepted() {
    return std::exchange(accepted_, {});
}

void Listener::incomingConnection(qintptr descriptor) {
    native_socket::prepare(descriptor);
    accepted_.push_back(descriptor);
}

}  // namespace tiller::simulator
