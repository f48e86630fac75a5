// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// A row for a digital input or output with terminal, name, and the state as symbol and text. An output is a
// button. An input is read-only.

#include <QAbstractButton>

class QLineEdit;

namespace tiller {

class IoChannel : public QAbstractButton {
    Q_OBJECT

public:
    enum class State { Unknown, Off, On, PendingOff, PendingOn };
    Q_ENUM(State)

    /// terminal  e.g. "DI 0"
    IoChannel(const QString& terminal, bool output, QWidget* parent = nullptr);

    QString terminal() const { return terminal_; }
    QString name() const { return name_; }
    void setName(const QString& name);
    State state() const { return state_; }
    void setState(State state);
    /// Marks the data as outdated. The last state is then shown in grey.
    void setStale(bool stale);
    bool isStale() const { return stale_; }
    /// why   the reason why the output cannot be switched, as a sentence; empty if it can be switched
    /// word  short text after the name
    void setObstacle(const QString& why, const QString& word = {});
    QString obstacle() const { return obstacle_; }
    /// The displayed state: "on", "off", "pending…", "no data".
    QString stateWord() const;
    static QString wordOf(State state);
    int stateWidth() const;
    void rename();

    QSize sizeHint() const override;
    QSize minimumSizeHint() const override;

    /// Row height without Touch density [px]. With Touch density, rows are as high as buttons.
    static constexpr int kHeight = 30;

Q_SIGNALS:
    void nameChanged();
    /// The user requested a pulse: the output is switched on, and off again after IoTab::kPulseMs.
    void pulseRequested();

protected:
    void paintEvent(QPaintEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;
    void contextMenuEvent(QContextMenuEvent* event) override;
    void changeEvent(QEvent* event) override;
    bool hitButton(const QPoint& position) const override;

private:
    void describe();
    void finishRename();
    QRect nameRect() const;

    QString terminal_;
    QString name_;
    QString obstacle_;
    QString obstacleWord_;
    bool output_;
    bool stale_ = true;
    State state_ = State::Unknown;
    QLineEdit* editor_ = nullptr;
};

}  // namespace tiller
