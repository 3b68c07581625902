<?php

declare(strict_types=1);

namespace Msisf\Tests\Support;

/** An authority of a test's own, with one certificate for the server at 127.0.0.1. */
final class CertificateAuthority
{
    private const KEY = ['private_key_bits' => 2048, 'private_key_type' => OPENSSL_KEYTYPE_RSA];

    public readonly string $authority;
    public readonly string $certificate;
    public readonly string $key;

    public function __construct(TemporaryFolder $folder, string $name)
    {
        [$this->authority, $this->certificate, $this->key] = array_map(
            static fn (string $part): string => $folder->path("$name-$part.pem"),
            ['ca', 'server', 'server-key'],
        );
        $config = $folder->path("$name.cnf");
        file_put_contents($config, "[req]\ndistinguished_name=dn\n[dn]\n[ca]\nbasicConstraints=CA:TRUE\n[server]\nsubjectAltName=IP:127.0.0.1\n");
        $authorityKey = openssl_pkey_new(self::KEY + ['config' => $config]);
        $request = openssl_csr_new(['commonName' => $name], $authorityKey, ['config' => $config]);
        $authority = openssl_csr_sign($request, null, $authorityKey, 2, ['config' => $config, 'x509_extensions' => 'ca', 'digest_alg' => 'sha256']);
        $serverKey = openssl_pkey_new(self::KEY + ['config' => $config]);
        $request = openssl_csr_new(['commonName' => 'server'], $serverKey, ['config' => $config]);
        $certificate = openssl_csr_sign($request, $authority, $authorityKey, 2, ['config' => $config, 'x509_extensions' => 'server', 'digest_alg' => 'sha256'], 7);
        openssl_x509_export_to_file($authority, $this->authority);
        openssl_x509_export_to_file($certificate, $this->certificate);
        openssl_pkey_export_to_file($serverKey, $this->key, null, ['config' => $config]);
    }
}
