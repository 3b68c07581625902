namespace Msisf.MySql;

/// <summary>What is asked of the encryption of a connection.</summary>
public enum TlsMode
{
    /// <summary>Nothing is asked: the provider encrypts if the server can, and does not verify the server.</summary>
    Default,

    /// <summary>No encryption.</summary>
    Disabled,

    /// <summary>Encryption, without verifying the server.</summary>
    Required,

    /// <summary>Encryption with a certificate of a trusted authority that names the host.</summary>
    VerifyIdentity,
}
