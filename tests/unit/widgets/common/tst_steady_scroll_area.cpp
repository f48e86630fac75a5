// SPDX-License-Identifier: GPL-3.0-or-later
#include <QLineEdit>
#include <QScrollBar>
#include <QTest>

#include "widgets/common/no_focus_scroll_area.h"

using namespace tiller;

class TestSteadyScrollArea : public QObject {
    Q_OBJECT

private:
    /// A wide widget with fields at both ends.
    struct Page {
        NoFocusScrollArea area;
        QLineEdit* near = new QLineEdit;
        QLineEdit* far = new QLineEdit;

        Page() {
            auto* content = new QWidget;
            content->setFixedSize(2000, 100);
            near->setParent(content);
            near->setGeometry(10, 10, 100, 30);
            far->setParent(content);
            far->setGeometry(1800, 10, 100, 30);
            area.setWidget(content);
            area.resize(300, 150);
            area.show();
            area.activateWindow();
            near->setFocus();
        }
        int scrolled() const { return area.horizontalScrollBar()->value(); }
    };

private Q_SLOTS:
    void focusOnAHiddenWidgetDoesNotScroll() {
        Page page;
        QVERIFY(QTest::qWaitForWindowActive(&page.area));
        QVERIFY(page.near->hasFocus());
        page.near->hide();
        QVERIFY(page.far->hasFocus());
        QCOMPARE(page.scrolled(), 0);
    }

    void focusOnADisabledWidgetDoesNotScroll() {
        Page page;
        QVERIFY(QTest::qWaitForWindowActive(&page.area));
        page.near->setEnabled(false);
        QVERIFY(page.far->hasFocus());
        QCOMPARE(page.scrolled(), 0);
    }

    void tabScrollsTheNextWidgetIntoView() {
        Page page;
        QVERIFY(QTest::qWaitForWindowActive(&page.area));
        QTest::keyClick(page.near, Qt::Key_Tab);
        QVERIFY(page.far->hasFocus());
        QVERIFY(page.scrolled() > 0);
    }
};

QTEST_MAIN(TestSteadyScrollArea)
#include "tst_steady_scroll_area.moc"
