// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The language of the window: its texts, those of Qt's own dialogs, and the decimal sign.

#include <QString>
#include <QTranslator>
#include <QVector>

namespace tiller::app {

struct Language {
    QString code;  ///< as in the name of its file: "de", "zh_CN"
    QString name;  ///< as its speakers write it
};

/// Those there are, English first.
const QVector<Language>& languages();
/// The one to show. English where neither is there.
/// chosen  its code; empty, or one that is not there: what the system speaks
QString languageFor(const QString& chosen);
/// The code of the one that windows are built in now.
QString shownLanguage();

/// The texts of one language, as long as it lives and until it takes another one. Numbers that are shown or typed have
/// the decimal sign of that language; files never ask.
/// Threads  GUI. A window that is there already keeps the texts it was built with
class LanguageTexts {
public:
    explicit LanguageTexts(const QString& chosen = {}) { take(chosen); }
    ~LanguageTexts();
    LanguageTexts(const LanguageTexts&) = delete;
    LanguageTexts& operator=(const LanguageTexts&) = delete;

    void take(const QString& chosen);
    const QString& code() const { return code_; }

private:
    void leave();

    QString code_;
    QTranslator texts_;
    QTranslator qtTexts_;
};

}  // namespace tiller::app
