// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Order of windows on the screen.

#include <QList>
#include <QObject>
#include <QRegion>
#include <QWindow>
#include <memory>

namespace tiller {

enum class Stacking {
    Done,
    NoneVisible,  ///< none of the reference windows is on the screen, e.g. because they are minimised
    Unsupported,  ///< not available on this platform
};

/// Keeps a window that the window manager does not manage, e.g. a tooltip, above all reference windows.
/// Windows of other programs are not moved, because some window managers, e.g. metacity, raise an unmanaged
/// window above all others at any time. Instead, the function returns the area that these windows would
/// cover.
/// covered  receives the parts of `unmanaged` that windows of other programs cover or would cover if they
///          were not below it [px, device-independent, relative to `unmanaged`]
Stacking keepAbove(const QList<QWindow*>& references, const QWindow& unmanaged, QRegion& covered);

/// Reports changes of the order and visibility of all windows on the screen, including those of other
/// programs. Uses a separate connection to the display server, because Qt determines which events its own
/// connection receives.
/// Threads  GUI
class StackingWatch : public QObject {
    Q_OBJECT

public:
    explicit StackingWatch(QObject* parent = nullptr);
    ~StackingWatch() override;

    /// False if the platform does not report changes, or if the connection was lost.
    bool isActive() const;

Q_SIGNALS:
    void changed();

private:
    struct Link;
    std::unique_ptr<Link> link_;  ///< null: not available on this platform
};

}  // namespace tiller
