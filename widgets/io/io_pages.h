// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The two pages of the tab "I/O": signals and gripper. The pages are separate, so that a change on one page
// does not move the rows of the other.

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

    /// Takes ownership of both pages.
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
