// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/tab_panel.h"

#include <QAbstractItemView>
#include <QApplication>
#include <QStackedWidget>
#include <QTabBar>
#include <algorithm>

namespace tiller::app {

namespace {

/// Moves the focus to the list or tree of a page. Otherwise, Qt would move it to the button that was used
/// last, e.g. "Run", which reacts to Return.
void focusPage(QWidget& page) {
    const QList<QAbstractItemView*> views = page.findChildren<QAbstractItemView*>();
    const auto view = std::ranges::find_if(
        views, [](const QAbstractItemView* each) { return each->isVisible() && each->isEnabled(); });
    (view != views.end() ? static_cast<QWidget*>(*view) : &page)->setFocus(Qt::OtherFocusReason);
}

}  // namespace

TabPanel::TabPanel(const QString& accessibleName, QWidget* parent)
    : Panel(QString(), parent), bar_(new QTabBar), pages_(new QStackedWidget) {
    bar_->setObjectName("tabs");
    bar_->setAccessibleName(accessibleName);
    bar_->setDrawBase(false);
    bar_->setExpanding(false);
    // Make the panel at least as wide as all tab titles.
    bar_->setUsesScrollButtons(false);
    bar_->setElideMode(Qt::ElideNone);
    setHeaderWidget(bar_);
    setContent(pages_);
    connect(bar_, &QTabBar::currentChanged, this, [this](int index) {
        Q_EMIT leaving();
        const bool hasFocus = pages_->isAncestorOf(QApplication::focusWidget());
        pages_->setCurrentIndex(index);
        if (hasFocus) {
            focusPage(*pages_->currentWidget());
        }
        bar_->updateGeometry();  // the title of the selected tab is bold and therefore needs more space
        Q_EMIT currentChanged();
    });
}

void TabPanel::add(const QString& name, const QString& title, QWidget& page) {
    pages_->addWidget(&page);
    bar_->setTabData(bar_->addTab(title), name);
}

void TabPanel::select(const QString& name) {
    for (int i = 0; i < bar_->count(); ++i) {
        if (bar_->tabData(i).toString() == name) {
            bar_->setCurrentIndex(i);
        }
    }
}

QString TabPanel::current() const {
    return bar_->tabData(bar_->currentIndex()).toString();
}

QWidget* TabPanel::currentPage() const {
    return pages_->currentWidget();
}

}  // namespace tiller::app

#include "moc_tab_panel.cpp"
