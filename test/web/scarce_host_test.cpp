// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
// The server on a host that has no threads or no memory for TLS left.
#include <gtest/gtest.h>
#include <openssl/ssl.h>
#include <openssl/tls1.h>
#include <pthread.h>
#include <sys/socket.h>
#include <unistd.h>

#include <array>
#include <cstddef>

#include "lamina/base/error.hpp"
#include "lamina/web/web_server.hpp"
#include "web/peer_stream.hpp"
#include "web/raw_client.hpp"
#include "web/site_of_fakes.hpp"

namespace lamina::test {
namespace {

/// Threads that are begun while it lives are to have a stack as large as all addresses together: there is
/// none.
class NoThreads {
 public:
  NoThreads() {
    pthread_getattr_default_np(&usual_);
    pthread_attr_t attributes;
    pthread_attr_init(&attributes);
    pthread_attr_setstacksize(&attributes, std::size_t{1} << 47);
    pthread_setattr_default_np(&attributes);
    pthread_attr_destroy(&attributes);
  }
  ~NoThreads() {
    pthread_setattr_default_np(&usual_);
    pthread_attr_destroy(&usual_);
  }
  NoThreads(const NoThreads&) = delete;
  NoThreads& operator=(const NoThreads&) = delete;

 private:
  pthread_attr_t usual_{};
};

TEST(ScarceHost, ClosesConnectionsForWhichThereIsNoThread) {
  SiteOfFakes site;
  WebServerSettings settings;
  settings.port = 0;
  settings.connections_of_client = 2;
  const WebServer server(settings, site.site, silentLog());
  {
    const NoThreads scarce;
    for (int i = 0; i < 5; ++i) {
      const RawClient client(server.port());
      client.send("GET /api/version HTTP/1.1\r\nHost: localhost\r\n\r\n");
      EXPECT_EQ(client.rest(), "");
    }
  }
  const RawClient client(server.port());
  client.send("GET /api/version HTTP/1.1\r\nHost: localhost\r\n\r\n");
  EXPECT_EQ(client.answer().substr(0, 12), "HTTP/1.1 200");
}

int approveTimestamps(const CT_POLICY_EVAL_CTX* /*policy*/, const STACK_OF(SCT) * /*timestamps*/,
                      void* /*argument*/) {
  return 1;
}

/// A context of which OpenSSL gives no connections: who checks timestamps of certificates may not have an
/// extension of the same number.
TlsContext contextWithoutConnections() {
  TlsContext context(SSL_CTX_new(TLS_server_method()));
  SSL_CTX_set_ct_validation_callback(context.get(), approveTimestamps, nullptr);
  SSL_CTX_add_custom_ext(context.get(), TLSEXT_TYPE_signed_certificate_timestamp, SSL_EXT_TLS1_3_SERVER_HELLO,
                         nullptr, nullptr, nullptr, nullptr, nullptr);
  return context;
}

TEST(ScarceHost, ServesNothingInPlainTextWhereTlsFails) {
  const TlsContext context = contextWithoutConnections();
  ASSERT_EQ(SSL_new(context.get()), nullptr);
  std::array<int, 2> ends{};
  ASSERT_EQ(::socketpair(AF_UNIX, SOCK_STREAM, 0, ends.data()), 0);
  {
    PeerSocket socket(ends[0], context.get());
    socket.allow(60.0);
    EXPECT_EQ(socket.shakeHands(), PeerResult::Closed);
  }
  ::close(ends[1]);
  ASSERT_EQ(::socketpair(AF_UNIX, SOCK_STREAM, 0, ends.data()), 0);
  {
    PeerSocket plain(ends[0], nullptr);
    EXPECT_EQ(plain.shakeHands(), PeerResult::Done);
  }
  ::close(ends[1]);
}

}  // namespace
}  // namespace lamina::test
