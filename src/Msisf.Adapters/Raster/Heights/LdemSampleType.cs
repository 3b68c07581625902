namespace Msisf.Adapters.Raster.Heights;

/// <summary>The format of a sample (SAMPLE_TYPE and SAMPLE_BITS of the label).</summary>
public enum LdemSampleType
{
    /// <summary>LSB_INTEGER, 16 bits: NASA's IMG products.</summary>
    Int16LittleEndian,

    /// <summary>MSB_INTEGER, 16 bits.</summary>
    Int16BigEndian,

    /// <summary>PC_REAL, 32 bits: NASA's FLOAT_IMG products.</summary>
    Float32LittleEndian,

    /// <summary>IEEE_REAL, 32 bits.</summary>
    Float32BigEndian,
}
