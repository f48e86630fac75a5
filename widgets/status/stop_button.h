// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The STOP button. It acts on the press of any mouse button or finger, and does not take the focus. It also
// acts while a menu is open, and menus do not cover it. Its second line shows the keys that also stop, or
// that a click is required.

#include <QAbstractButton>

namespace tiller {

class StopButton : public QAbstractButton {
    Q_OBJECT

public:
    explicit StopButton(QWidget* parent = nullptr);

    /// keys  true if Space and Esc also stop; initially false
    void setKeysStop(bool keys);
    bool keysStop() const { return keysStop_; }

    QSize sizeHint() const override { return {230, 60}; }
    QSize minimumSizeHint() const override { return {128, 60}; }

Q_SIGNALS:
    void stopRequested();

protected:
    void paintEvent(QPaintEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseReleaseEvent(QMouseEvent* event) override;
    void mouseDoubleClickEvent(QMouseEvent* event) override;
    bool event(QEvent* event) override;
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    void keepUncovered(QWidget& popup) const;

    bool keysStop_ = true;
};

}  // namespace tiller
