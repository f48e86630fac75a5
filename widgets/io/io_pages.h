// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// What the tab "I/O" is made of: the signals, and the gripper that hangs on them. Two pages of one place, so
// that neither moves the other's rows.

#include <QWidget>

class QStackedWidget;

namespace tiller {

class GripperPanel;
class IoTab;
class SegmentedControl;

class IoPages : public QWidget {
    Q_OBJECT

public:
    enum class Page { Signals, Gripper };

    /// Takes both into its layout.
    IoPages(IoTab* signalsPage, GripperPanel* gripperPage, QWidget* parent = nullptr);

    Page page() const;
    void show(Page page);
    using QWidget::show;

Q_SIGNALS:
    void pageChanged();

private:
    SegmentedControl* choice_;
    QStackedWidget* pages_;
};

}  // namespace tiller
