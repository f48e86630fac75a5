// SPDX-License-Identifier: MIT
#include "robot/live/detail/allowed_origins.h"

#include <QHostAddress>
#include <QNetworkInterface>
#include <QSysInfo>
#include <QUrl>

namespace tiller::live {

namespace {

QString normalized(const QString& origin) {
    QString text = origin.trimmed().toLower();
    while (text.endsWith(QLatin1Char('/')) && !text.endsWith(QLatin1String("://"))) {
        text.chop(1);
    }
    return text;
}

bool isWellFormed(const QString& origin) {
    if (origin == QLatin1String("null") || origin == QLatin1String("file://")) {
        return true;
    }
    const QUrl url(origin, QUrl::StrictMode);
    return url.isValid() && !url.scheme().isEmpty() && !url.host().isEmpty() && url.path().isEmpty() &&
           !url.hasQuery() && !url.hasFragment() && url.userInfo().isEmpty();
}

bool isThisMachine(const QString& host) {
    if (host == QLatin1String("localhost")) {
        return true;
    }
    const QHostAddress address(host);
    if (!address.isNull()) {
        return address.isLoopback() || QNetworkInterface::allAddresses().contains(address);
    }
    const QString name = QSysInfo::machineHostName().toLower();
    return !name.isEmpty() && (host == name || host == name + QLatin1String(".local"));
}

}  // namespace

Result<AllowedOrigins> AllowedOrigins::from(const std::vector<Text>& origins) {
    AllowedOrigins allowed;
    for (const Text& origin : origins) {
        const QString text = normalized(origin);
        if (!isWellFormed(text)) {
            return Error{
                ErrorCode::AddressInvalid, QStringLiteral("allow the origin \"%1\"").arg(origin),
                QStringLiteral(
                    "an origin must have the form https://host or https://host:port, or be file:// or null")};
        }
        allowed.listed_ << text;
    }
    return allowed;
}

bool AllowedOrigins::allow(const QString& origin) const {
    if (origin.isEmpty()) {
        return true;
    }
    const QString text = normalized(origin);
    if (listed_.contains(text)) {
        return true;
    }
    const QUrl url(text, QUrl::StrictMode);
    const bool isWeb = url.scheme() == QLatin1String("http") || url.scheme() == QLatin1String("https");
    return isWeb && isWellFormed(text) && isThisMachine(url.host());
}

}  // namespace tiller::live
