// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/common/hold_witness.h"

#include <QCoreApplication>
#include <QGuiApplication>

#ifdef TILLER_HAS_XCB
#include "widgets/common/xcb_witness.h"
#endif

namespace tiller {

namespace {

/// Used on platforms without a key-state query.
class NoWitness : public HoldWitness {
public:
    bool isThere() const override { return false; }
    void want(bool) override {}
    Word leftButton() const override { return {}; }
    Word key(KeyCode) const override { return {}; }
    std::int64_t waitingNs() const override { return 0; }
    QString description() const override {
        return QCoreApplication::translate("HoldWitness",
                                           "Key-state check unavailable on this platform (%1): Tiller relies "
                                           "on window events for held keys.")
            .arg(QGuiApplication::platformName());
    }
};

}  // namespace

std::unique_ptr<HoldWitness> HoldWitness::ofThisPlatform() {
#ifdef TILLER_HAS_XCB
    if (QGuiApplication::platformName() == QLatin1String("xcb")) {
        return std::make_unique<XcbWitness>();
    }
#endif
    return none();
}

std::unique_ptr<HoldWitness> HoldWitness::none() {
    return std::make_unique<NoWitness>();
}

}  // namespace tiller
