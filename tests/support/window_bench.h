// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The real window with its own settings and a simulated robot, all on one virtual clock.

#include <QTemporaryDir>
#include <QTest>
#include <optional>

#include "app/main_window.h"
#include "tests/support/virtual_cell.h"

namespace tiller::test {

struct WindowBench {
    VirtualClock clock;
    QTemporaryDir folder;
    QString file = folder.filePath("settings.ini");
    app::MainWindow window{app::Settings(file), clock};
    VirtualCell cell;

    explicit WindowBench(const simulator::SimulatorOptions& robot = VirtualCell::options())
        : cell(clock, window.session(), robot) {}

    /// Shows and activates the window. The default size is used if no size is given.
    void show(std::optional<QSize> size = {}) {
        if (size) {
            window.resize(*size);
        }
        window.show();
        window.activateWindow();
        if (!QTest::qWaitForWindowActive(&window)) {
            qFatal("the window did not become active");
        }
    }
    template <class Widget>
    Widget& find(const char* name) {
        auto* found = window.findChild<Widget*>(QString::fromLatin1(name));
        if (found == nullptr) {
            qFatal("there is no %s", name);
        }
        return *found;
    }
};

}  // namespace tiller::test
