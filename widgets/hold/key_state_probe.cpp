// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/hold/key_state_probe.h"

#include <QCoreApplication>
#include <QGuiApplication>

#ifdef TILLER_HAS_XCB
#include "widgets/hold/xcb_key_state_probe.h"
#endif

namespace tiller {

namespace {

/// Probe for platforms without a key-state query.
class NoKeyStateProbe : public KeyStateProbe {
public:
    bool isThere() const override { return false; }
    void want(bool) override {}
    void query() override {}
    Word leftButton() const override { return {}; }
    Word key(KeyCode) const override { return {}; }
    std::int64_t waitingNs() const override { return 0; }
    QString description() const override {
        return QCoreApplication::translate("KeyStateProbe",
                                           "Key-state check unavailable on this platform (%1): Tiller relies "
                                           "on window events to detect key releases.")
            .arg(QGuiApplication::platformName());
    }
};

}  // namespace

std::unique_ptr<KeyStateProbe> KeyStateProbe::ofThisPlatform() {
#ifdef TILLER_HAS_XCB
    if (QGuiApplication::platformName() == QLatin1String("xcb")) {
        return std::make_unique<XcbKeyStateProbe>();
    }
#endif
    return none();
}

std::unique_ptr<KeyStateProbe> KeyStateProbe::none() {
    return std::make_unique<NoKeyStateProbe>();
}

}  // namespace tiller
