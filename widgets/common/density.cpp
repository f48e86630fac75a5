// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/common/density.h"

#include <QApplication>
#include <QEvent>
#include <QHeaderView>
#include <QTableView>

#include "widgets/common/theme.h"

namespace tiller {
namespace {

constexpr char kDensityProperty[] = "tillerDensity";
constexpr char kCrampedProperty[] = "tillerCramped";

class RowHeight : public QObject {
public:
    explicit RowHeight(QTableView& table) : QObject(&table), table_(table) {
        table.installEventFilter(this);
        apply();
    }

protected:
    bool eventFilter(QObject* watched, QEvent* event) override {
        if (event->type() == QEvent::StyleChange) {
            apply();
        }
        return QObject::eventFilter(watched, event);
    }

private:
    void apply() { table_.verticalHeader()->setDefaultSectionSize(rowHeight(currentDensity())); }

    QTableView& table_;
};

}  // namespace

Density currentDensity() {
    const auto* app = QCoreApplication::instance();
    const QVariant set = app == nullptr ? QVariant() : app->property(kDensityProperty);
    return set.isValid() ? static_cast<Density>(set.toInt()) : Density::Mouse;
}

void applyDensity(QApplication& application, Density density) {
    application.setProperty(kDensityProperty, static_cast<int>(density));
    applyTheme(application, Theme::current());
}

int rowHeight(Density density) {
    return density == Density::Compact ? 28 : density == Density::Mouse ? 36 : 44;
}

int keyHeight(Density density) {
    return density == Density::Compact ? 32 : density == Density::Mouse ? 38 : 48;
}

int touchHeight() {
    const auto* app = QCoreApplication::instance();
    const bool room = app == nullptr || !app->property(kCrampedProperty).toBool();
    return currentDensity() == Density::Touch && room ? keyHeight(Density::Touch) : 0;
}

void setRoomForTouch(QApplication& application, bool room) {
    if (application.property(kCrampedProperty).toBool() == !room) {
        return;
    }
    application.setProperty(kCrampedProperty, !room);
    if (currentDensity() == Density::Touch) {
        applyTheme(application, Theme::current());
    }
}

void followDensity(QTableView& table) {
    new RowHeight(table);
}

}  // namespace tiller
