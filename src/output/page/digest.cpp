#include "output/page/digest.hpp"

#include <array>
#include <memory>

#include <glib.h>

namespace dashpad::output {

std::string policy_hash(std::string_view text) {
  struct Release {
    void operator()(GChecksum* checksum) const { g_checksum_free(checksum); }
    void operator()(gchar* characters) const { g_free(characters); }
  };
  const std::unique_ptr<GChecksum, Release> checksum{g_checksum_new(G_CHECKSUM_SHA256)};
  g_checksum_update(checksum.get(), reinterpret_cast<const guchar*>(text.data()),
                    static_cast<gssize>(text.size()));
  std::array<guchar, 32> digest{};
  gsize length = digest.size();
  g_checksum_get_digest(checksum.get(), digest.data(), &length);
  const std::unique_ptr<gchar, Release> base64{g_base64_encode(digest.data(), length)};
  return std::string{"sha256-"} + base64.get();
}

}  // namespace dashpad::output
