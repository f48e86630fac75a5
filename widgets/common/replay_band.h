// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The line under a part of the window that shows what was, not what is: says of when, and leads back to what is live.
// What stands above it may give way: with it or without, the panel needs the same height, and no key moves.

#include <QFrame>

class QToolButton;

namespace tiller {

class ElidedLabel;

class ReplayBand : public QFrame {
    Q_OBJECT

public:
    /// name   of the object; its key is "<name>.live"
    /// above  what gives way, in the same layout; null: nothing
    explicit ReplayBand(const QString& name, QWidget* above = nullptr, QWidget* parent = nullptr);

    /// Empty: what is shown is live, there is no band once the pointer has left it.
    void tell(const QString& words);
    QString words() const;

Q_SIGNALS:
    /// Back to what is live.
    void liveWanted();

protected:
    void changeEvent(QEvent* event) override;
    void leaveEvent(QEvent* event) override;

private:
    void style();
    void setShown(bool shown);

    QWidget* above_;
    ElidedLabel* words_;
    QToolButton* live_;
    bool styling_ = false;
};

}  // namespace tiller
