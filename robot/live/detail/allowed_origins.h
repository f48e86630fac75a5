// SPDX-License-Identifier: MIT
#pragma once

// Decides which web pages may read live data. A browser lets every page open a WebSocket to any server and
// sends the page's origin with the request, so the server must refuse foreign pages. Private to this module.

#include <QString>
#include <QStringList>
#include <vector>

#include "robot/core/result.h"
#include "robot/core/text.h"

namespace tiller::live {

class AllowedOrigins {
public:
    /// Errors   AddressInvalid: not of the form scheme://host[:port], "file://" or "null"
    static Result<AllowedOrigins> from(const std::vector<Text>& origins);

    /// Allows clients without an origin (not a browser), pages of this machine (localhost, its host name or
    /// one of its addresses) and the listed origins. A name that DNS resolves to this machine is not
    /// sufficient, because the owner of the name chooses the address (DNS rebinding).
    bool allow(const QString& origin) const;

private:
    QStringList listed_;
};

}  // namespace tiller::live
