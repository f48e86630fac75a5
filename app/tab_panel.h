// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// A panel whose title bar contains tabs, one for each page.

#include "widgets/common/panel.h"

class QStackedWidget;
class QTabBar;

namespace tiller::app {

class TabPanel : public Panel {
    Q_OBJECT

public:
    explicit TabPanel(const QString& accessibleName, QWidget* parent = nullptr);

    /// Adds a page at the end. The first page is selected.
    /// name  identifies the page in the settings and in select()
    void add(const QString& name, const QString& title, QWidget& page);
    /// Does nothing if there is no page with this name.
    void select(const QString& name);
    QString current() const;
    QWidget* currentPage() const;
    const QTabBar& bar() const { return *bar_; }

Q_SIGNALS:
    /// Emitted before the page changes.
    void leaving();
    void currentChanged();

private:
    QTabBar* bar_;
    QStackedWidget* pages_;
};

}  // namespace tiller::app
