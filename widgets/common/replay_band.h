// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// A band below a part of the window that shows past data. The band displays the time and a button that
// returns to live data. The widget above becomes lower while the band is visible, so that no button moves.

#include <QFrame>

class QToolButton;

namespace tiller {

class ElidedLabel;

class ReplayBand : public QFrame {
    Q_OBJECT

public:
    /// name   objectName; the name of the button is "<name>.live"
    /// above  widget in the same layout whose height is reduced; null if there is none
    explicit ReplayBand(const QString& name, QWidget* above = nullptr, QWidget* parent = nullptr);

    /// Sets the text. An empty text means live data: the band is hidden as soon as the pointer has left it.
    void tell(const QString& words);
    QString words() const;

Q_SIGNALS:
    /// The user clicked "Back to live".
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
