KPL/MK

The kernels that MSISF loads, in this order; where two hold the same data, the later one wins. What each one is stands in
README.md. To use others, write a meta-kernel like this one and name it with --kernels FILE.

A relative name starts at the folder of this file (SPICE's own programs start at the working directory: run them from here).

\begindata

KERNELS_TO_LOAD = ( 'naif0012.tls'
                    'moon_080317.tf'
                    'moon_assoc_me.tf'
                    'moon_pa_de421_1900-2050.bpc'
                    'de421.bsp' )

\begintext
