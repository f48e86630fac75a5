// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/language.h"

#include <QCoreApplication>
#include <QLibraryInfo>
#include <QLocale>
#include <algorithm>

// The macro must be outside all namespaces, because it declares a function of generated code.
static void initTranslations() {
    Q_INIT_RESOURCE(tiller_translations);
}

namespace tiller::app {
namespace {

constexpr char kShownLanguage[] = "tillerLanguage";

}  // namespace

const QVector<Language>& languages() {
    static const QVector<Language> all{{QStringLiteral("en"), QStringLiteral("English")},
                                       {QStringLiteral("de"), QStringLiteral("Deutsch")},
                                       {QStringLiteral("es"), QStringLiteral("Español")},
                                       {QStringLiteral("fr"), QStringLiteral("Français")},
                                       {QStringLiteral("ja"), QStringLiteral("日本語")},
                                       {QStringLiteral("zh_CN"), QStringLiteral("简体中文")}};
    return all;
}

QString languageFor(const QString& chosen) {
    const auto isThere = [](const QString& code) {
        return std::ranges::any_of(languages(), [&](const Language& one) { return one.code == code; });
    };
    if (isThere(chosen)) {
        return chosen;
    }
    const QStringList spoken = QLocale::system().uiLanguages();  // e.g. "de-AT", "de", or "zh-Hans-CN"
    for (const QString& tag : spoken) {
        const QLocale locale(tag);
        if (const QString whole = locale.name(); isThere(whole)) {
            return whole;
        }
        if (const QString language = locale.name().section(QLatin1Char('_'), 0, 0); isThere(language)) {
            return language;
        }
    }
    return languages().front().code;
}

QString shownLanguage() {
    const auto* application = QCoreApplication::instance();
    const QVariant set = application == nullptr ? QVariant() : application->property(kShownLanguage);
    return set.isValid() ? set.toString() : languages().front().code;
}

LanguageTexts::~LanguageTexts() {
    leave();
}

void LanguageTexts::take(const QString& chosen) {
    initTranslations();
    leave();
    code_ = languageFor(chosen);
    // Also load a translation for English, because it contains the plural forms.
    if (texts_.load(QStringLiteral("tiller_") + code_, QStringLiteral(":/i18n"))) {
        QCoreApplication::installTranslator(&texts_);
    }
    const QString qt = QLibraryInfo::path(QLibraryInfo::TranslationsPath);
    if (qtTexts_.load(QStringLiteral("qtbase_") + code_, qt)) {
        QCoreApplication::installTranslator(&qtTexts_);
    }
    // Use the regional formats of the system if the user has not selected a language.
    QCoreApplication::instance()->setProperty(kShownLanguage, code_);
    QLocale::setDefault(chosen.isEmpty() ? QLocale::system() : QLocale(code_));
}

void LanguageTexts::leave() {
    QCoreApplication::removeTranslator(&texts_);
    QCoreApplication::removeTranslator(&qtTexts_);
}

}  // namespace tiller::app
