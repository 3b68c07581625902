namespace Msisf.Cli.Options;

/// <summary>File format of the layers.</summary>
internal enum LayersFormat
{
    Fits,
    Npy,
}
