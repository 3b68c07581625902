namespace Msisf.MySql;

/// <summary>The required encryption of a connection.</summary>
public enum TlsMode
{
    /// <summary>No requirement: the provider encrypts if the server supports it, and does not verify the server.</summary>
    Default,

    /// <summary>No encryption.</summary>
    Disabled,

    /// <summary>Encryption, without verifying the server.</summary>
    Required,

    /// <summary>Encryption with a certificate that names the host and is signed by a trusted authority.</summary>
    VerifyIdentity,
}
