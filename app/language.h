// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The language of the user interface: translations, including those of Qt's dialogs, and the decimal
// separator.

#include <QString>
#include <QTranslator>
#include <QVector>

namespace tiller::app {

struct Language {
    QString code;  ///< code in file names, e.g. "de", "zh_CN"
    QString name;  ///< native name of the language
};

/// Available languages, English first.
const QVector<Language>& languages();
/// Returns the language to use; English if there is no matching translation.
/// chosen  language code; if empty or unknown, the system language
QString languageFor(const QString& chosen);
/// Code of the language in use for new windows.
QString shownLanguage();

/// Loads the texts of one language until another language is loaded or the object is destroyed. The decimal
/// separator of the language applies to displayed and entered numbers, but not to files.
/// Threads  GUI. Existing windows keep their texts
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
