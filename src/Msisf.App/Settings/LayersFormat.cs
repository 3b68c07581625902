namespace Msisf.App.Settings;

/// <summary>File format of the layers.</summary>
internal enum LayersFormat
{
    Fits,
    Npy,
}
