// SPDX-License-Identifier: MIT
#pragma once

// HTTP/1.1 at byte level: parses requests from a stream, writes responses, and parses multipart forms with
// files.
//
// Qt's QHttpServer is not used because its license is GPL-3.0-only, whereas robot/ has the MIT license so
// that others can link it. QHttpServer also owns its sockets, so that link faults could not be simulated.

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace tiller::simulator {

struct HttpRequest {
    std::string method;                                        ///< e.g. "GET"
    std::string path;                                          ///< decoded, without the query
    std::vector<std::pair<std::string, std::string>> headers;  ///< names in lower case
    std::string body;
    bool keepAlive = true;

    /// Value of a header; empty if there is no such header.
    /// name  header name in lower case
    std::string_view header(std::string_view name) const;
};

struct HttpResponse {
    int status = 200;
    std::string body;
    std::string contentType = "application/json";
    std::vector<std::pair<std::string, std::string>> headers;
    std::function<bool()> due;  ///< the response is delayed until this returns true; empty: sent at once

    std::string toBytes(bool keepAlive, bool withBody) const;
};

/// Memory use is limited for any input.
class HttpParser {
public:
    static constexpr std::size_t kLargestHead = 32 * 1024;
    static constexpr std::size_t kLargestBody = 16 * 1024 * 1024;

    void feed(std::string_view bytes);
    /// Returns the next complete request. Empty if no request is complete or after an error.
    std::optional<HttpRequest> next();
    /// HTTP status to send before closing the connection: 400, 413, 431, 501 or 505; 0 if there is no error.
    int fault() const { return fault_; }
    /// Returns true once for each request that expects "100 Continue" before its body.
    bool takeContinue() { return std::exchange(continue_, false); }

private:
    bool readHead();
    void readHeader(std::string_view line);
    bool readBody();
    bool readChunks();
    std::optional<std::string_view> line();
    void fail(int status) { fault_ = fault_ == 0 ? status : fault_; }

    std::string buffer_;
    std::size_t at_ = 0;  ///< number of buffer bytes already processed
    HttpRequest request_;
    std::size_t headSize_ = 0;
    bool inBody_ = false;
    bool chunked_ = false;
    bool sawLength_ = false;
    std::size_t length_ = 0;
    std::optional<std::size_t> chunk_;  ///< remaining bytes of the current chunk
    bool inTrailer_ = false;
    bool continue_ = false;
    int fault_ = 0;
};

/// Decodes sequences such as %41. Empty if a % is not followed by two hexadecimal digits.
std::optional<std::string> percentDecoded(std::string_view text);

struct FormFile {
    std::string fileName;
    std::string content;
};
/// Returns the field with this name from a multipart/form-data body.
std::optional<FormFile> fileOfForm(std::string_view contentType, std::string_view body,
                                   std::string_view field);

}  // namespace tiller::simulator
