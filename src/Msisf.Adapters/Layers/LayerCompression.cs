namespace Msisf.Adapters.Layers;

/// <summary>Compression of the layers in a FITS file.</summary>
public enum LayerCompression
{
    /// <summary>None: IMAGE extensions.</summary>
    None,

    /// <summary>Without loss, in tiles of whole rows, each by gzip after its bytes are sorted by significance (GZIP_2).</summary>
    Gzip,
}
